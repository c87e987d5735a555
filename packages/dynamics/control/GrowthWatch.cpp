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
// A slip of L renews the contacts, and with them the state.
// The second share was chosen between known runs: sound ones reach 0.11 L, bad ones 3.7 L and more.
constexpr double part_of_L = 0.1;        // in a forced step
constexpr double part_of_L_within = 1.0; // in a step that meets the tolerance

bool isPowerOfTen(std::int64_t count)
{
  while (count % 10 == 0) {
    count /= 10;
  }
  return count == 1;
}
} // namespace

bool GrowthWatch::hidesGrowth(Step const& step)
{
  double before = step.rate_before;
  if (isForced(step)) {
    least_ = least_ < 0 ? before : std::min(least_, before);
    before = least_;
  } else {
    least_ = -1;
  }
  const double part = isForced(step) ? part_of_L : part_of_L_within;
  return (step.is_forced || slip_distance_ > 0) && step.rate > growth * before &&
         step.rate * step.step_size > part * slip_distance_;
}

std::string GrowthWatch::describe(Step const& step, std::int64_t count) const
{
  struct Words
  {
    std::string which, what, cure;
  };
  const Words words =
    is_prescribed_
      ? Words{" of the prescribed size", "slipped by more than a tenth of L", "smaller steps"}
    : step.is_forced
      ? Words{" of the smallest size", "did not meet the tolerance", "a smaller 'Smallest Step'"}
      : Words{" within the tolerance, of size", "slipped by more than L", "a smaller 'Tolerance'"};
  return std::to_string(count) + (count == 1 ? " step" : " steps") + words.which + " " +
         formatShort(step.step_size) + " s, the last one to t = " + formatShort(step.time) +
         " s, " + words.what + " while the slip rate grew to " + formatShort(step.rate) +
         " m/s: earthquakes may be lost. Choose " + words.cure;
}

std::optional<Warning> GrowthWatch::note(Step const& step)
{
  if (!hidesGrowth(step)) {
    return std::nullopt;
  }
  auto& count = isForced(step) ? forced_ : others_;
  auto const text = describe(step, ++count);
  if (most_ > 0 && count >= most_) {
    throw SolveError(text + " and begin a new run: --restart would continue after the lost "
                            "earthquakes. 'Time Stepping / Most Hiding Steps' is the limit.");
  }
  return isPowerOfTen(count) ? std::optional<Warning>({"hidden growth", text + "."}) : std::nullopt;
}
} // namespace asperity::dynamics
