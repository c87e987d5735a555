#include "catalogue/events/FaultRates.hpp"

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

std::vector<double> countedNodes(io::OutputContext const& context)
{
  std::vector<double> counted(context.domain("fault").numOwned(), 1);
  if (context.fields.hasField("fault", "prescribed")) {
    context.fields.field("fault", "prescribed").values(counted);
    for (double& value : counted) {
      value = value != 0 ? 0 : 1;
    }
  }
  if (context.fields.hasField("fault", "given_slip")) {
    std::vector<double> given;
    context.fields.field("fault", "given_slip").values(given);
    for (std::size_t i = 0; i < counted.size(); ++i) {
      counted[i] = given[i] != 0 ? 1 : counted[i];
    }
  }
  return counted;
}
} // namespace asperity::catalogue
