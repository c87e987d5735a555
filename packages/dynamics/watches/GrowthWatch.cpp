#include "dynamics/watches/GrowthWatch.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "dynamics/watches/PowersOfTen.hpp"
#include "parameters/Entries.hpp"

#include <algorithm>
#include <string>

namespace asperity::dynamics
{
namespace
{
constexpr double growth = 2;
// A slip of L renews the contacts, and with them the state. Sound steps within the tolerance reach
// 0.11 L, steps that lose events 3.7 L and more.
constexpr double part_of_L = 0.1;        // in a forced step
constexpr double part_of_L_within = 1.0; // in a step that meets the tolerance
// Where slip is slow and friction weakens. In wedge_2d.xml steps reach 0.25 L with a tolerance of
// 1e-5 and 1.1 L with 1e-3, and no event is lost; they reach 3 L with 0.01, and one of 28 events is
// lost, and 8 L with 0.1, and all are lost.
constexpr double most_slow_slip = 2.0; // in units of L

struct GrowthSettings
{
  int most_hiding = 10;
};

Entries<GrowthSettings> growthEntries()
{
  return Entries<GrowthSettings>().integer(
    "Most Hiding Steps", &GrowthSettings::most_hiding, Range::atLeast(0),
    "The run ends with an error after this number of steps that hide a growing slip rate: the peak "
    "slip rate has more than doubled, and the fault slips in that step by more than a tenth of L "
    "if the step does not meet the tolerance even at the smallest size, by more than L if it meets "
    "it. The two kinds are counted apart, and a restart continues the counts: the first begins "
    "again with a smaller Smallest Step, the second with a smaller Tolerance. 0 means no limit, "
    "but a warning.");
}

constexpr char const* smaller_step = "a smaller 'Smallest Step'";
constexpr char const* smaller_tolerance = "a smaller 'Tolerance' of the step control";
} // namespace

bool GrowthWatch::hidesGrowth(Step const& step)
{
  double before = step.rate_before;
  if (isForced(step)) {
    memory_.least = memory_.least < 0 ? before : std::min(memory_.least, before);
    before = memory_.least;
  } else {
    memory_.least = -1;
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
      ? Words{" of the smallest size", "did not meet the tolerance", smaller_step}
      : Words{" within the tolerance, of size", "slipped by more than L", smaller_tolerance};
  return std::to_string(count) + (count == 1 ? " step" : " steps") + words.which + " " +
         formatShort(step.step_size) + " s, the last one to t = " + formatShort(step.time) +
         " s, " + words.what + " while the slip rate grew to " + formatShort(step.rate) +
         " m/s: earthquakes may be lost. Choose " + words.cure;
}

std::optional<Warning> GrowthWatch::note(Step const& step)
{
  if (!hidesGrowth(step)) {
    return noteSlowSlip(step);
  }
  auto& count = isForced(step) ? memory_.forced : memory_.others;
  last_description_ = describe(step, ++count);
  return isPowerOfTen(count) || count == most_
           ? std::optional<Warning>({"hidden growth", last_description_ + "."})
           : std::nullopt;
}

std::optional<Warning> GrowthWatch::noteSlowSlip(Step const& step)
{
  if (!(step.slow_slip > most_slow_slip) || !isPowerOfTen(++memory_.damped)) {
    return std::nullopt;
  }
  return Warning{
    "hidden growth",
    std::to_string(memory_.damped) + (memory_.damped == 1 ? " step" : " steps") +
      ", the last one of size " + formatShort(step.step_size) +
      " s to t = " + formatShort(step.time) + " s, slipped by more than " +
      formatShort(most_slow_slip) + " L (" + formatShort(step.slow_slip) +
      " L) where friction weakens and slip is slow: steps of this size damp what would "
      "grow to an earthquake. Choose " +
      (is_prescribed_   ? "smaller steps"
       : step.is_forced ? smaller_step
                        : smaller_tolerance) +
      "."};
}

Teuchos::RCP<const Teuchos::ParameterList> GrowthWatch::validParameters()
{
  return growthEntries().list();
}

GrowthWatch::GrowthWatch(Teuchos::ParameterList const& parameters, WatchContext const& context)
    : GrowthWatch(context.slip_distance,
                  growthEntries().read(parameters, parameters.name()).most_hiding, !context.adapts)
{
  tolerance_ = context.tolerance;
  if (context.fault.stateDecides()) {
    slow_.emplace(Slow{context.fault, SlowSlip(context.weakening, context.slow_rate)});
  }
}

void GrowthWatch::note(WatchedState const& now, Notes& notes)
{
  if (now.step && slow_) {
    auto const& communicator = *slow_->fault.surface().communicator();
    notes.add(
      note({now.step->is_forced, now.time, now.step->size, now.step->rate_before,
            now.sample.peakSlipRate(),
            slow_->slip.largestRatio(now.sample.slipRates(), now.step->size, communicator)}));
  }
}

void GrowthWatch::save(Archive& archive) const
{
  archive.set("least", memory_.least);
  archive.set("forced", memory_.forced);
  archive.set("others", memory_.others);
  archive.set("damped", memory_.damped);
  archive.set("tolerance", tolerance_);
}

void GrowthWatch::restore(Archive const& archive, Restart const& restart)
{
  memory_ = {};
  if (!archive.has("forced")) {
    return;
  }
  if (!(tolerance_ < archive.getDouble("tolerance"))) {
    memory_.others = archive.getInteger("others");
    memory_.damped = archive.getInteger("damped");
  }
  if (!restart.has_smaller_steps) {
    memory_.least = archive.getDouble("least");
    memory_.forced = archive.getInteger("forced");
  }
}

void GrowthWatch::requireUsefulRun() const
{
  for (const bool is_forced : {true, false}) {
    const auto count = is_forced ? memory_.forced : memory_.others;
    if (most_ == 0 || count < most_) {
      continue;
    }
    auto const text = !last_description_.empty()
                        ? last_description_
                        : std::to_string(count) + (count == 1 ? " step" : " steps") +
                            " before this restart hid a growing slip rate: earthquakes may "
                            "be lost. Choose " +
                            (is_forced ? smaller_step : smaller_tolerance);
    throw UselessRun(text + " and begin a new run: --restart would continue after the lost "
                            "earthquakes. 'Time Stepping / Most Hiding Steps' is the limit.");
  }
}
} // namespace asperity::dynamics

ASPERITY_REGISTER(asperity::dynamics::WatchRegistry, "growth_watch",
                  asperity::dynamics::WatchKindOf<asperity::dynamics::GrowthWatch>)
