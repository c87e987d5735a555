#include "dynamics/control/RichardsonControl.hpp"

#include "base/Errors.hpp"
#include "parameters/Parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::dynamics
{
namespace
{
// A larger step is tried if its expected error is at most this fraction of the tolerance: a pair
// that fails costs more than to try the larger step later.
constexpr double safety = 0.8;

// Guesses come from the step of twice the size if its alpha is at most this far from the straight
// line (root mean square over the fault). Where alpha falls by 10 on a hundredth of the fault, the
// distance is 1.
constexpr double near = 0.1;

Entries<AdaptiveSettings> richardsonEntries()
{
  AdaptiveSettings defaults;
  defaults.norm = Norm::maximum;
  Entries<AdaptiveSettings> result(defaults);
  result
    .real(RichardsonControl::toleranceEntry(), &AdaptiveSettings::tolerance, "-", Range::open(0, 1),
          "A pair of steps is accepted if its estimated error is at most this: in alpha, and in "
          "all else on a scale on which it matters as much. The estimate follows from the "
          "difference to one step of twice the size, and for waves from accelerations.")
    .choice("Norm", &AdaptiveSettings::norm, normWords(),
            "Selects the norm in which the error is measured over the fault. A mean dilutes the "
            "error of a nucleation much smaller than the fault.");
  return addCommonEntries(
    result, "The first steps have this size, which is at most half of the largest one; 0 means "
            "the smallest step.");
}

AdaptiveSettings settingsOf(Teuchos::ParameterList const& parameters, ControlContext const& context)
{
  auto const& clock = context.step.clock();
  ASPERITY_REQUIRE(clock.finestLevel() > 0, context.path
                                              << " / Smallest Step = " << clock.stepSize(0)
                                              << " s has to be at most half of the largest one: "
                                                 "a pair is compared with one step of twice the "
                                                 "size.");
  auto settings = richardsonEntries().read(parameters, context.path);
  settings.setLevels(clock, context.wave_rate);
  return settings;
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> RichardsonControl::validParameters()
{
  return richardsonEntries().list();
}

std::string RichardsonControl::meaning()
{
  return "steps come in pairs, which one step of twice the size confirms; the pair is kept and the "
         "next size predicted.";
}

RichardsonControl::RichardsonControl(Teuchos::ParameterList const& parameters,
                                     ControlContext const& context)
    : RichardsonControl(context, settingsOf(parameters, context))
{
}

RichardsonControl::RichardsonControl(ControlContext const& context,
                                     AdaptiveSettings const& settings)
    : StepControl(context)
    , settings_(settings)
    , extrapolation_(std::ldexp(1., context.order) - 1)
    , error_ratio_(std::ldexp(1., context.order + 1))
    , waves_(context.step.body(), context.step.surface(), context.step.update(), settings.waves)
{
  // A pair is compared with a step of twice the size.
  ASPERITY_ASSERT(settings.finest_level > settings.coarsest_level);
  memory_.level = std::max(settings.first_level, settings.coarsest_level + 1);
}

void RichardsonControl::save(Archive& archive, StateArchive const& states) const
{
  StepControl::save(archive, states);
  archive.set("level_before", last_.level);
  archive.set("error", last_.error);
  archive.set("previous_error", last_.previous_error);
  if (last_.before) {
    states.save(archive, "before", *last_.before);
  }
}

void RichardsonControl::restore(Archive const& archive, StateArchive const& states)
{
  StepControl::restore(archive, states);
  last_ = {};
  if (!archive.has("level_before")) { // another control has written it
    return;
  }
  last_.level = static_cast<int>(archive.getInteger("level_before"));
  last_.error = archive.getDouble("error");
  last_.previous_error = archive.getDouble("previous_error");
  if (archive.has("before/time")) {
    last_.before = states.load(archive, "before");
  }
}

void RichardsonControl::adaptToClock()
{
  StepControl::adaptToClock();
  last_ = {};
}

AcceptedStep RichardsonControl::advance(State& current, SolveCount& count)
{
  if (trialPassesInstant(current)) {
    memory_.trial.reset();
  }
  auto const left = ticksLeft(current.time);
  auto accepted = memory_.trial ? secondOfPair(current)
                  : left > 1    ? firstOfPair(current, count)
                                : singleStep(current, count);
  accepted.within_tolerance = accepted.error <= settings_.tolerance;
  ++memory_.num_steps;
  if (resume(current)) {
    // Loads may change at an instant: the last pairs do not predict the next one.
    last_.before.reset();
    last_.error = last_.previous_error = 0;
  }
  return accepted;
}

AcceptedStep RichardsonControl::firstOfPair(State& current, SolveCount& count)
{
  shorten(clock().levelWithin(ticksLeft(current.time) / 2));
  const int first_level = memory_.level;
  auto pair = acceptablePair(current, count);
  noteRefinement(first_level);
  AcceptedStep accepted;
  accepted.iterations = pair.first->iterations;
  last_.before = std::move(current);
  last_.level = memory_.level;
  last_.previous_error = last_.error;
  last_.error = pair.error;
  current = std::move(pair.first->state);
  memory_.trial = std::move(pair.second);
  accepted.level = memory_.level;
  accepted.error = last_.error;
  return accepted;
}

AcceptedStep RichardsonControl::secondOfPair(State& current)
{
  AcceptedStep accepted;
  current = std::move(memory_.trial->state);
  accepted.iterations = memory_.trial->iterations;
  memory_.trial.reset();
  accepted.level = memory_.level;
  accepted.error = last_.error;
  predictLevel(last_.error);
  noteRefinement(accepted.level);
  return accepted;
}

AcceptedStep RichardsonControl::singleStep(State& current, SolveCount& count)
{
  shorten(clock().finestLevel());
  auto next = attempt(current, memory_.level, constantGuess(current), count);
  if (!next) {
    throwStepFailure(current, memory_.level);
  }
  last_.before.reset();
  current = std::move(next->state);
  AcceptedStep accepted;
  accepted.level = memory_.level;
  accepted.iterations = next->iterations;
  return accepted;
}

Guess RichardsonControl::extrapolated(State const& current, double steps) const
{
  if (!last_.before) {
    return constantGuess(current);
  }
  const double ratio = steps / 2 * std::ldexp(1., last_.level - memory_.level);
  return {1 + ratio, current, *last_.before};
}

std::optional<State> RichardsonControl::wholeStep(State const& current, SolveCount& count)
{
  auto trial = attemptAtFault(current, memory_.level - 1, extrapolated(current, 2), count);
  return trial ? std::optional<State>(std::move(trial->state)) : std::nullopt;
}

bool RichardsonControl::isNearStraightLine(State const& current, State const& end) const
{
  auto const expected = blend(extrapolated(current, 2));
  return dynamics::distance(surface(), end.alpha, expected.alpha) <= near;
}

RichardsonControl::Pair RichardsonControl::pairOf(State const& current,
                                                  std::optional<State> const& whole,
                                                  SolveCount& count)
{
  State const* const end = whole && isNearStraightLine(current, *whole) ? &*whole : nullptr;
  Pair pair;
  pair.error = std::numeric_limits<double>::infinity();
  pair.first = attempt(current, memory_.level,
                       end ? Guess{0.5, *end, current} : extrapolated(current, 1), count);
  if (pair.first) {
    State const& middle = pair.first->state;
    pair.second =
      attempt(middle, memory_.level, end ? constantGuess(*end) : Guess{2, middle, current}, count);
  }
  if (whole && pair.second) {
    State const& last = pair.second->state;
    pair.error = std::max(distance(*whole, last, settings_.norm) / extrapolation_,
                          waves_.errorBetween(current, last, clock().stepSize(memory_.level)));
  }
  return pair;
}

RichardsonControl::Pair RichardsonControl::acceptablePair(State const& current, SolveCount& count)
{
  std::optional<State> whole;
  while (true) {
    const bool finest = memory_.level >= settings_.finest_level;
    if (!whole) {
      whole = wholeStep(current, count);
    }
    auto pair = whole || finest ? pairOf(current, whole, count) : Pair();
    if (pair.second && (pair.error <= settings_.tolerance || finest)) {
      return pair;
    }
    if (finest) {
      throwStepFailure(current, memory_.level);
    }
    // The first step of the pair is the whole step of the next smaller one.
    ++memory_.level;
    last_.error /= error_ratio_;
    whole = pair.first ? std::optional<State>(std::move(pair.first->state)) : std::nullopt;
  }
}

void RichardsonControl::predictLevel(double error)
{
  const double trend =
    last_.previous_error > 0 ? std::clamp(error / last_.previous_error, 0.5, 4.) : 1;
  const double expected = error * trend;
  if (expected > settings_.tolerance && memory_.level < settings_.finest_level) {
    ++memory_.level;
    last_.error /= error_ratio_;
  } else if (expected * error_ratio_ <= safety * settings_.tolerance &&
             memory_.level > settings_.coarsest_level + 1) {
    --memory_.level;
    last_.error *= error_ratio_;
  }
}

ASPERITY_REGISTER(StepControlRegistry, "Richardson", StepControlKindOf<RichardsonControl>)
} // namespace asperity::dynamics
