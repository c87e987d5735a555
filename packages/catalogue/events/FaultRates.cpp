#include "catalogue/events/FaultRates.hpp"

#include "base/parallel/Reductions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::catalogue
{
double crossing(double before, double after, double threshold)
{
  const double smallest = std::numeric_limits<double>::min(); // a node at rest
  const double log_before = std::log(std::max(before, smallest));
  const double log_after = std::log(std::max(after, smallest));
  return (std::log(threshold) - log_before) / (log_after - log_before);
}

double peakRate(std::array<double, 3> const& times, std::array<double, 3> const& rates)
{
  const double highest = rates[1];
  const double lowest = std::min(rates[0], rates[2]);
  if (highest < std::max(rates[0], rates[2]) || highest > 2 * lowest || highest == lowest) {
    return highest;
  }
  // Drops of the logarithm to either side, per time: both are positive or one is zero.
  const double before = times[1] - times[0], after = times[2] - times[1];
  const double rise = std::log(highest / rates[0]) / before;
  const double fall = std::log(highest / rates[2]) / after;
  const double slope = (rise * after - fall * before) / (before + after); // at the middle sample
  const double curvature = (rise + fall) / (before + after);
  return highest * std::exp(slope * slope / (4 * curvature));
}

FaultRates::FaultRates(io::OutputDomain const& fault, io::FieldRegistry const& fields)
    : fault_(fault)
    , slip_rate_(fields.field("fault", "slip_rate"))
    , free_(fault.numOwned(), 1)
{
  if (fields.hasField("fault", "prescribed")) {
    fields.field("fault", "prescribed").values(free_);
    for (double& value : free_) {
      value = value != 0 ? 0 : 1;
    }
  }
}

FaultRates::Sample FaultRates::sample() const
{
  Sample now;
  slip_rate_.values(now.rates);
  double largest = 0;
  for (std::size_t i = 0; i < now.rates.size(); ++i) {
    now.rates[i] *= free_[i];
    largest = std::max(largest, now.rates[i]);
  }
  now.peak = maxOverRanks(largest, *fault_.comm);
  return now;
}
} // namespace asperity::catalogue
