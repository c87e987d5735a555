#pragma once

#include "io/FieldRegistry.hpp"
#include "io/OutputDomain.hpp"

#include <array>
#include <vector>

namespace asperity::catalogue
{
// Where between two samples a rate meets the threshold, linear in its logarithm: 0 to 1.
double crossing(double before, double after, double threshold);

// The rate [m/s] at the vertex of the parabola in time [s] through the logarithms of three
// successive samples. The middle sample itself if it is not the largest, or more than twice one of
// the others: such samples do not resolve a peak.
double peakRate(std::array<double, 3> const& times, std::array<double, 3> const& rates);

// The slip rate where friction decides on it: zero at the nodes whose slip rate is prescribed
// (field `prescribed`, if there is one), which are no part of an earthquake.
class FaultRates
{
public:
  FaultRates(io::OutputDomain const& fault, io::FieldRegistry const& fields);

  // (num_owned) [m/s], and the largest over all ranks. Collective.
  struct Sample
  {
    std::vector<double> rates;
    double peak = 0;
  };
  Sample sample() const;

  // 1 or, at a node with prescribed slip rate, 0. (num_owned)
  std::vector<double> const& free() const { return free_; }

private:
  io::OutputDomain const& fault_;
  io::OutputField const& slip_rate_;
  std::vector<double> free_;
};
} // namespace asperity::catalogue
