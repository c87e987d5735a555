#include "dynamics/watches/StallWatch.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "dynamics/watches/PowersOfTen.hpp"
#include "parameters/Entries.hpp"

namespace asperity::dynamics
{
namespace
{
// Whether a count of steps is 100, 1000, ...
bool isLogged(std::int64_t count)
{
  constexpr std::int64_t first = 100;
  return count % first == 0 && isPowerOfTen(count / first);
}

struct StallSettings
{
  int most_forced = 10000;
};

Entries<StallSettings> stallEntries()
{
  return Entries<StallSettings>().integer(
    "Most Forced Steps", &StallSettings::most_forced, Range::atLeast(0),
    "The run ends with an error after this number of steps in a row that even at the smallest size "
    "did not meet the tolerance; 0 means that there is no limit. A restart continues the count "
    "unless Smallest Step is smaller.");
}

constexpr char const* advice = "Try a smaller 'Smallest Step', a looser tolerance if it is below "
                               "1e-6, and check the slip rates, "
                               "lengths and stresses of the friction law.";
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> StallWatch::validParameters()
{
  return stallEntries().list();
}

StallWatch::StallWatch(Teuchos::ParameterList const& parameters, WatchContext const&)
    : StallWatch(stallEntries().read(parameters, parameters.name()).most_forced)
{
}

void StallWatch::note(WatchedState const& now, Notes& notes)
{
  if (auto const& step = now.step) {
    note({step->is_smallest, step->is_forced, now.time, step->size, step->time_left}, notes);
  }
}

void StallWatch::note(Step const& step, Notes& notes)
{
  last_ = step;
  smallest_ = step.is_smallest ? smallest_ + 1 : 0;
  forced_ = step.is_forced ? forced_ + 1 : 0;
  const std::string size = formatShort(step.step_size) + " s";
  if (isLogged(forced_)) {
    notes.add(Warning{"forced steps", "The last " + std::to_string(forced_) +
                                        " steps, of the smallest size " + size +
                                        ", did not meet the tolerance. " + advice});
  } else if (forced_ == 0 && isLogged(smallest_)) {
    notes.lines.push_back("The last " + std::to_string(smallest_) +
                          " steps had the smallest size, " + size + "; the end of the run is " +
                          formatShort(step.time_left / step.step_size) + " such steps away.");
  }
}

void StallWatch::requireUsefulRun() const
{
  if (last_ && most_forced_ > 0 && forced_ >= most_forced_) {
    throw SolveError("At t = " + formatShort(last_->time) + " s the last " +
                     std::to_string(forced_) + " steps, of the smallest size " +
                     formatShort(last_->step_size) + " s, did not meet the tolerance. " + advice +
                     " 'Time Stepping / Most Forced Steps' is the limit.");
  }
}

void StallWatch::save(Archive& archive) const
{
  archive.set("smallest", smallest_);
  archive.set("forced", forced_);
}

void StallWatch::restore(Archive const& archive, Restart const& restart)
{
  const bool goes_on = archive.has("forced") && !restart.has_smaller_steps;
  smallest_ = goes_on ? archive.getInteger("smallest") : 0;
  forced_ = goes_on ? archive.getInteger("forced") : 0;
}
} // namespace asperity::dynamics

ASPERITY_REGISTER(asperity::dynamics::WatchRegistry, "stall_watch",
                  asperity::dynamics::WatchKindOf<asperity::dynamics::StallWatch>)
