#include "dynamics/control/StallWatch.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

namespace asperity::dynamics
{
namespace
{
constexpr std::int64_t first_warning = 100;

// first_warning times 1, 10, 100, ...
bool isWorthALine(std::int64_t count)
{
  while (count > first_warning && count % 10 == 0) {
    count /= 10;
  }
  return count == first_warning;
}

constexpr char const* advice = "Try a smaller 'Smallest Step', a looser tolerance if it is below "
                               "1e-6, and check "
                               "the slip rates, lengths and stresses of the friction law.";
} // namespace

std::string StallWatch::note(Step const& step)
{
  auto& [smallest, forced] = memory_;
  smallest = step.is_smallest ? smallest + 1 : 0;
  forced = step.is_forced ? forced + 1 : 0;
  const std::string size = formatShort(step.step_size) + " s";
  if (most_forced_ > 0 && forced >= most_forced_) {
    throw SolveError("At t = " + formatShort(step.time) + " s the last " + std::to_string(forced) +
                     " steps, of the smallest size " + size + ", did not meet the tolerance. " +
                     advice + " 'Time Stepping / Most Forced Steps' is the limit.");
  }
  if (isWorthALine(forced)) {
    return "Warning: the last " + std::to_string(forced) + " steps, of the smallest size " + size +
           ", did not meet the tolerance. " + advice;
  }
  if (forced == 0 && isWorthALine(smallest)) {
    return "The last " + std::to_string(smallest) + " steps had the smallest size, " + size +
           "; the end of the run is " + formatShort(step.time_left / step.step_size) +
           " such steps away.";
  }
  return "";
}
} // namespace asperity::dynamics
