#pragma once

#include "dynamics/Body.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <chrono>
#include <ctime>

class Stopwatch
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// CPU time of this process: unlike wall time, it hardly sees other work on the machine.
class CpuStopwatch
{
public:
  double seconds() const { return double(std::clock() - start_) / CLOCKS_PER_SEC; }

private:
  std::clock_t start_ = std::clock();
};

// Products with K, timed between the steps of the stretch.
class ProductMeter
{
public:
  explicit ProductMeter(asperity::dynamics::Body const& body)
      : body_(body)
      , x_(body.vector())
      , y_(body.vector())
  {
    x_->randomize();
  }
  void sample()
  {
    body_.matrices.stiffness->apply(*x_, *y_); // brings the matrix into the caches
    const CpuStopwatch watch;
    for (int i = 0; i < 3; ++i) {
      body_.matrices.stiffness->apply(*x_, *y_);
    }
    seconds_ += watch.seconds();
    count_ += 3;
  }
  double mean() const { return seconds_ / count_; }

private:
  asperity::dynamics::Body const& body_;
  asperity::RCP<asperity::Vector> x_, y_;
  double seconds_ = 0;
  int count_ = 0;
};

// The largest memory that this process has used: VmHWM of the kernel, in bytes.
double peakBytes();

// The wall time of one product with K, the mean of ten.
double productSeconds(asperity::dynamics::Body const& body);
