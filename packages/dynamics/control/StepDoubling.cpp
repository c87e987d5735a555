#include "dynamics/control/StepDoubling.hpp"

#include <algorithm>

namespace asperity::dynamics
{
namespace
{
Entries<AdaptiveSettings> doublingEntries()
{
  Entries<AdaptiveSettings> result;
  result.real(
    StepDoubling::toleranceEntry(), &AdaptiveSettings::tolerance, "-", Range::open(0, 1),
    "A step is accepted if alpha, and all else on a scale on which it matters as much, differs by "
    "at most this between one step and two of half its size, as root mean square over the fault.");
  return addCommonEntries(result, "The first trial step has this size; 0 means the smallest step.");
}

AdaptiveSettings doublingSettings(Teuchos::ParameterList const& parameters,
                                  ControlContext const& context)
{
  auto settings = doublingEntries().read(parameters, context.path);
  settings.setLevels(context.step.clock(), context.wave_rate);
  return settings;
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> StepDoubling::validParameters()
{
  return doublingEntries().list();
}

std::string StepDoubling::meaning()
{
  return "a step is the largest one that two steps of half its size confirm (thesis A.3).";
}

StepDoubling::StepDoubling(Teuchos::ParameterList const& parameters, ControlContext const& context)
    : StepDoubling(context, doublingSettings(parameters, context))
{
}

StepDoubling::StepDoubling(ControlContext const& context, AdaptiveSettings const& settings)
    : StepControl(context)
    , settings_(settings)
    , waves_(context.step.body(), context.step.surface(), context.step.update(), settings.waves)
{
  memory_.level = settings.first_level;
}

// Finds the largest step from `current` that can be solved, of at most the present size.
void StepDoubling::findTrial(State const& current, SolveCount& count)
{
  while (!memory_.trial) {
    memory_.trial = attempt(current, memory_.level, constantGuess(current), count);
    if (!memory_.trial) {
      if (memory_.level >= settings_.finest_level) {
        throwStepFailure(current, memory_.level);
      }
      ++memory_.level;
    }
  }
}

AcceptedStep StepDoubling::advance(State& current, SolveCount& count)
{
  if (trialPassesInstant(current)) {
    memory_.trial.reset();
  }
  shorten(clock().levelWithin(ticksLeft(current.time)));
  const int first_level = memory_.level;
  findTrial(current, count);
  AcceptedStep accepted;
  std::optional<Trial> next;
  if (!coarsen(current, next, accepted.error, count)) {
    accepted.within_tolerance = refine(current, next, accepted.error, count);
    // A step cut short to the smallest size cannot be compared with smaller ones.
    const bool is_cut_short = memory_.level_after != ControlMemory::none;
    accepted.within_tolerance |= is_cut_short && memory_.level == first_level;
  }
  noteRefinement(first_level);
  accepted.level = memory_.level;
  accepted.iterations = memory_.trial->iterations;
  current = std::move(memory_.trial->state);
  memory_.trial = std::move(next);
  ++memory_.num_steps;
  resume(current);
  return accepted;
}

// Doubles the trial as long as one step of twice its size agrees with two of its size. `next` is
// the step after the trial, if it is known.
bool StepDoubling::coarsen(State const& current, std::optional<Trial>& next, double& error,
                           SolveCount& count)
{
  bool coarsened = false;
  const int coarsest =
    std::max(settings_.coarsest_level, clock().levelWithin(ticksLeft(current.time)));
  while (memory_.level > coarsest) {
    State const& end = memory_.trial->state;
    next = attempt(end, memory_.level, {2, end, current}, count);
    if (!next) {
      break;
    }
    auto doubled = attemptAtFault(current, memory_.level - 1, constantGuess(next->state), count);
    if (!doubled) {
      break;
    }
    const double difference =
      std::max(distance(doubled->state, next->state, settings_.norm),
               waves_.errorBetween(current, next->state, clock().stepSize(memory_.level - 1)));
    if (!(difference <= settings_.tolerance)) {
      break;
    }
    error = difference;
    memory_.trial = complete(current, std::move(*doubled));
    next.reset();
    --memory_.level;
    coarsened = true;
  }
  return coarsened;
}

// Halves the trial until it agrees with two steps of half its size. False if the smallest step does
// not.
bool StepDoubling::refine(State const& current, std::optional<Trial>& next, double& error,
                          SolveCount& count)
{
  while (memory_.level < settings_.finest_level) {
    State const& end = memory_.trial->state;
    auto first = attempt(current, memory_.level + 1, {0.5, end, current}, count);
    auto second = first ? attemptAtFault(first->state, memory_.level + 1, constantGuess(end), count)
                        : std::nullopt;
    if (second) {
      error = std::max(distance(end, second->state, settings_.norm),
                       waves_.errorBetween(current, end, clock().stepSize(memory_.level)));
      if (error <= settings_.tolerance) {
        return true;
      }
    }
    ++memory_.level;
    next = second ? std::optional<Trial>(complete(first->state, std::move(*second))) : std::nullopt;
    memory_.trial = std::move(first);
    findTrial(current, count);
  }
  return false;
}

ASPERITY_REGISTER(StepControlRegistry, "Step Doubling", StepControlKindOf<StepDoubling>)
} // namespace asperity::dynamics
