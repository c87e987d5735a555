#include "scenario/run/SkippedTimes.hpp"

#include "base/Text.hpp"
#include "parameters/fields/Expression.hpp"

#include <algorithm>
#include <string>

namespace asperity::scenario
{
namespace
{
void collectTimes(ParameterList const& list, std::vector<double>& times)
{
  for (auto const& each : list) {
    if (list.isSublist(each.first)) {
      collectTimes(list.sublist(each.first), times);
    } else if (list.isType<std::string>(each.first)) {
      auto const found = timesComparedIn(list.get<std::string>(each.first));
      times.insert(times.end(), found.begin(), found.end());
    }
  }
}
} // namespace

SkippedTimes::SkippedTimes(ParameterList const& deck)
{
  for (auto const* part : {"Boundary Conditions", "Bulk", "Friction"}) { // whatever loads
    collectTimes(deck.sublist(part), times_);
  }
  std::sort(times_.begin(), times_.end());
  times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
}

std::optional<Warning> SkippedTimes::note(double begin, double end)
{
  auto const first = std::upper_bound(times_.begin(), times_.end(), begin);
  auto const behind = std::upper_bound(first, times_.end(), end);
  if (has_warned_ || behind - first < 2) {
    return std::nullopt;
  }
  has_warned_ = true;
  return Warning{"loads between two steps",
                 "The step from t = " + formatShort(begin) + " s to " + formatShort(end) +
                   " s passes " + formatShort(*first) + " s and " + formatShort(*(behind - 1)) +
                   " s, with which expressions of the deck compare t. What loads do between these "
                   "times is not seen. Name them in 'Time Stepping / Instants'."};
}
} // namespace asperity::scenario
