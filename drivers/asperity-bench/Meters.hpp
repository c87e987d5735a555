#pragma once

#include "dynamics/Body.hpp"

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

// The largest memory that this process has used: VmHWM of the kernel, in bytes.
double peakBytes();

// The wall time of one product with K, the mean of ten.
double productSeconds(asperity::dynamics::Body const& body);
