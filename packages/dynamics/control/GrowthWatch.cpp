#include "dynamics/control/GrowthWatch.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <string>

namespace asperity::dynamics
{
namespace
{
constexpr double growth = 2;
constexpr double part_of_L = 0.1;

bool isPowerOfTen(std::int64_t count)
{
  while (count % 10 == 0) {
    count /= 10;
  }
  return count == 1;
}
} // namespace

std::optional<Warning> GrowthWatch::note(Step const& step)
{
  if (!step.is_forced && !is_prescribed_) {
    least_ = -1;
    return std::nullopt;
  }
  least_ = least_ < 0 ? step.rate_before : std::min(least_, step.rate_before);
  const bool grows = step.rate > growth * least_;
  if (!grows || !(step.rate * step.step_size > part_of_L * slip_distance_)) {
    return std::nullopt;
  }
  ++count_;
  const std::string text =
    std::to_string(count_) + (count_ == 1 ? " step" : " steps") + " of the " +
    (is_prescribed_ ? "prescribed" : "smallest") + " size " + formatShort(step.step_size) +
    " s, the last one to t = " + formatShort(step.time) +
    (is_prescribed_ ? " s, slipped by more than a tenth of L" : " s, did not meet the tolerance") +
    " while the slip rate grew, to " + formatShort(step.rate) +
    " m/s: earthquakes may be lost. Choose " +
    (is_prescribed_ ? "smaller steps" : "a smaller 'Smallest Step'");
  if (most_ > 0 && count_ >= most_) {
    throw SolveError(text + ", and begin anew; --restart goes on with it from here, after what has "
                            "been lost. 'Time Stepping / Most Hiding Steps' is the limit.");
  }
  return isPowerOfTen(count_) ? std::optional<Warning>({"hidden growth", text + "."})
                              : std::nullopt;
}
} // namespace asperity::dynamics
