#include "dynamics/control/StepControl.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace asperity::dynamics
{
namespace
{
char const* reason(StepStatus status)
{
  switch (status) {
  case StepStatus::rate_problem_failed: return "a rate problem did not converge";
  case StepStatus::state_failed: return "the state could not be updated";
  case StepStatus::fixed_point_failed: return "the fixed point iteration did not converge";
  default: return "it was solved";
  }
}

// result := weight a + (1 - weight) b
void combine(double weight, ConstNodeView const& a, ConstNodeView const& b, NodeView const& result)
{
  const double of_b = 1 - weight;
  Kokkos::parallel_for(
    "asperity::dynamics::combine", RangePolicy(0, result.extent(0)),
    KOKKOS_LAMBDA(int i) { result(i) = weight * a(i) + of_b * b(i); });
}
} // namespace

State blend(Guess const& guess)
{
  State result = guess.a.sameShape();
  State::visitFields(
    [&](FieldInfo const& info, auto const& to, auto const& a, auto const& b) {
      if (info.is_guessed) {
        combine(guess.weight, valuesOf(a), valuesOf(b), overwritten(to));
      }
    },
    result, guess.a, guess.b);
  return result;
}

StepControl::StepControl(ControlContext const& context)
    : step_(context.step)
    , instants_(context.instants)
    , place_of_(context.place_of)
    , start_(context.displacement)
{
  memory_.largest_displacement = context.least_displacement;
  memory_.largest_velocity = context.least_velocity;
}

namespace
{
// |a - b| / largest, where `largest` grows to |b - start|; 0 / 0 = 0. Norms are maxima.
double relativeDistance(Vector const& a, Vector const& b, Vector const* start, double& largest)
{
  Vector difference(b, Teuchos::Copy);
  if (start != nullptr) {
    difference.update(-1, *start, 1);
  }
  largest = std::max(largest, difference.normInf());
  difference.update(1, a, -1, b, 0);
  const double error = difference.normInf();
  return error == 0 ? 0 : error / largest;
}
} // namespace

double StepControl::distance(State const& a, State const& b, Norm norm)
{
  const double of_fault = step_.distance(a, b, norm);
  const double of_body = step_.fault().stateDecides() ? 0 : distanceInBody(a, b);
  return std::isfinite(of_body) ? std::max(of_fault, of_body) : of_body;
}

double StepControl::distanceInBody(State const& a, State const& b)
{
  const double of_u = relativeDistance(*a.u, *b.u, start_.get(), memory_.largest_displacement);
  if (step_.body().matrices.is_massless) {
    return of_u;
  }
  const double of_v = relativeDistance(*a.v, *b.v, nullptr, memory_.largest_velocity);
  return std::isfinite(of_v) ? std::max(of_u, of_v) : of_v;
}

std::optional<Trial> StepControl::attempt(State const& from, int level, Guess const& guess,
                                          SolveCount& count)
{
  auto trial = attemptAtFault(from, level, guess, count);
  return trial ? std::optional<Trial>(complete(from, std::move(*trial))) : std::nullopt;
}

std::optional<FaultTrial> StepControl::attemptAtFault(State const& from, int level,
                                                      Guess const& guess, SolveCount& count)
{
  State state = blend(guess);
  auto const result = step_.solveAtFault(from, level, state, count);
  last_status_ = result.status;
  not_finite_.reset();
  if (result.solved()) {
    FaultTrial trial{std::move(state), result.iterations, result.rest};
    if (!step_.fault().stateDecides()) {
      step_.complete(*trial.rest, from, trial.state);
      trial.rest.reset();
    }
    return trial;
  }
  not_finite_ = firstNotFiniteAtFault(state);
  not_finite_ =
    not_finite_ ? not_finite_ : firstNotFinite("the sum of loads", step_.lastRightSide());
  return std::nullopt;
}

Trial StepControl::complete(State const& from, FaultTrial&& trial)
{
  if (trial.rest) {
    step_.complete(*trial.rest, from, trial.state);
  }
  return {std::move(trial.state), trial.iterations};
}

AcceptedStep StepControl::makeStep(State& current, int level, SolveCount& count)
{
  memory_.level = std::max(level, clock().levelWithin(ticksLeft(current.time)));
  auto next = attempt(current, memory_.level, constantGuess(current), count);
  if (!next) {
    throwStepFailure(current, memory_.level);
  }
  current = std::move(next->state);
  ++memory_.num_steps;
  AcceptedStep accepted;
  accepted.level = memory_.level;
  accepted.iterations = next->iterations;
  return accepted;
}

void StepControl::throwStepFailure(State const& from, int level) const
{
  std::ostringstream lost; // of the lowest rank that has a value that is not finite
  onEveryRank(*surface().communicator(), [&] {
    if (not_finite_) {
      lost << "; " << not_finite_->field << " became " << not_finite_->value;
      const int vertex = not_finite_->vertexIn(step_.body(), surface());
      lost << (place_of_ ? " at " + place_of_(vertex) : "");
      throw SolveError(failure(from, level, lost.str()));
    }
  });
  throw SolveError(failure(from, level, ""));
}

std::string StepControl::failure(State const& from, int level, std::string const& lost) const
{
  auto const [why, cure] = sizeOfLastStep();
  std::ostringstream message;
  message << "Step " << memory_.num_steps + 1 << ", from t = " << clock().seconds(from.time)
          << " s: a step of " << clock().stepSize(level) << " s, " << why
          << ", failed: " << reason(last_status_) << lost
          << (lost.empty() ? ". Try "
                           : ". If a load or a parameter of the deck is wrong there, correct it: "
                             "--restart-from begins with it. Otherwise try ")
          << cure
          << ", or a looser tolerance or more iterations of Coupling and TNNMG: --restart goes on "
             "with them.";
  return message.str();
}

DyadicTime::Ticks StepControl::ticksLeft(DyadicTime::Ticks time) const
{
  auto const next = std::upper_bound(instants_.begin(), instants_.end(), time);
  return next == instants_.end() ? std::numeric_limits<DyadicTime::Ticks>::max() : *next - time;
}

bool StepControl::trialPassesInstant(State const& current) const
{
  return memory_.trial && memory_.trial->state.time - current.time > ticksLeft(current.time);
}

void StepControl::shorten(int level)
{
  if (memory_.level < level) {
    if (memory_.level_after == ControlMemory::none) {
      memory_.level_after = memory_.level;
    }
    memory_.level = level;
  }
}

void StepControl::noteRefinement(int level_before)
{
  if (memory_.level_after != ControlMemory::none && memory_.level > level_before) {
    memory_.level_after = memory_.level;
  }
}

bool StepControl::resume(State const& current)
{
  const bool is_met = std::binary_search(instants_.begin(), instants_.end(), current.time);
  if (!is_met || memory_.level_after == ControlMemory::none) {
    return false;
  }
  memory_.level = memory_.level_after;
  memory_.level_after = ControlMemory::none;
  memory_.trial.reset();
  return true;
}

void StepControl::adaptToClock()
{
  const int finest = clock().finestLevel();
  memory_.level = std::min(memory_.level, finest);
  memory_.level_after = std::min(memory_.level_after, finest);
  memory_.trial.reset();
}

void StepControl::save(Archive& archive, StateArchive const& states) const
{
  archive.set("level", memory_.level);
  archive.set("level_after", memory_.level_after);
  archive.set("num_steps", memory_.num_steps);
  archive.set("largest_displacement", memory_.largest_displacement);
  archive.set("largest_velocity", memory_.largest_velocity);
  if (memory_.trial) {
    archive.set("trial/iterations", memory_.trial->iterations);
    states.save(archive, "trial/state", memory_.trial->state);
  }
}

void StepControl::restore(Archive const& archive, StateArchive const& states)
{
  memory_.level = static_cast<int>(archive.getInteger("level"));
  memory_.level_after = static_cast<int>(archive.getInteger("level_after"));
  memory_.num_steps = archive.getInteger("num_steps");
  memory_.largest_displacement = archive.getDouble("largest_displacement");
  memory_.largest_velocity = archive.getDouble("largest_velocity");
  memory_.trial.reset();
  if (archive.has("trial/iterations")) {
    memory_.trial = Trial{states.load(archive, "trial/state"),
                          static_cast<int>(archive.getInteger("trial/iterations"))};
  }
}
} // namespace asperity::dynamics
