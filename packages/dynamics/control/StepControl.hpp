#pragma once

#include "dynamics/StateArchive.hpp"
#include "dynamics/control/ControlContext.hpp"
#include "dynamics/control/NotFinite.hpp"
#include "dynamics/fault/FaultMotion.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asperity::dynamics
{
// First guess for the end of a step: weight * a + (1 - weight) * b for the fields that are guessed.
struct Guess
{
  double weight;
  State const& a;
  State const& b;
};
inline Guess constantGuess(State const& state) { return {1, state, state}; }
// A state with these, whose other values are not set.
State blend(Guess const& guess);

// A solved step that has not been accepted.
struct Trial
{
  State state;        // at its end
  int iterations = 0; // of the fixed point
};

// A step that is solved at the fault alone: enough to be compared with others, unless the whole
// body is compared (Fault::stateDecides).
struct FaultTrial
{
  State state; // at its end; until it is complete, v off the fault is a guess, and the rest not set
  int iterations = 0;
  std::optional<PendingStep> rest; // none: it is complete
};

struct AcceptedStep
{
  int level = 0;
  int iterations = 0;           // of the fixed point, in the step that was accepted
  double error = 0;             // estimated, in the norm of the control
  bool within_tolerance = true; // false: even the smallest step did not meet it
};

// What every control remembers from one step to the next.
struct ControlMemory
{
  int level = 0;
  std::int64_t num_steps = 0;
  std::optional<Trial> trial; // the next step, already solved
  // The level to go on with after the instant ahead, if steps are cut short to meet it, or `none`.
  static constexpr int none = -1;
  int level_after = none;
  // The largest displacement since the start [m] and velocity [m/s] anywhere in the body so far, at
  // least those of ControlContext, on which errors are measured where the whole body is compared.
  double largest_displacement = 0, largest_velocity = 0;
};

// Chooses step sizes. Throws SolveError if even the smallest step cannot be solved.
//
// No step passes an instant: the end of a run, or a time at which a load changes. The time left
// before an instant is covered by smaller and smaller steps, each the largest size that fits, so
// that no size occurs twice. After the instant the control goes on with its earlier size.
class StepControl
{
public:
  explicit StepControl(ControlContext const& context);
  virtual ~StepControl() = default;
  // Replaces `current` by the state after the next accepted step.
  virtual AcceptedStep advance(State& current, SolveCount& count) = 0;
  // Whether step sizes follow from an estimated error.
  virtual bool adapts() const { return true; }

  ControlMemory const& memory() const { return memory_; }
  // What a restart goes on from. A control that remembers more extends these three functions.
  virtual void save(Archive& archive, StateArchive const& states) const;
  virtual void restore(Archive const& archive, StateArchive const& states);
  // Adapts the memory restored from a run with another smallest step: forgets trials and errors,
  // and raises step sizes that are too small now.
  virtual void adaptToClock();

protected:
  // Tries a step of the given level, from a guess of its end. Empty if the step is not solved.
  std::optional<Trial> attempt(State const& from, int level, Guess const& guess, SolveCount& count);
  // The same at the fault alone. complete() must come before any other attempt, or never.
  std::optional<FaultTrial> attemptAtFault(State const& from, int level, Guess const& guess,
                                           SolveCount& count);
  Trial complete(State const& from, FaultTrial&& trial);
  // Replaces `current` by the end of a step of the level, or of a smaller one that passes no
  // instant; gives up if it is not solved. For controls without an estimate of the error.
  AcceptedStep makeStep(State& current, int level, SolveCount& count);
  // The error of a step that ends in a, if b is its exact end. Where no state of the fault decides
  // on steps, it includes the largest error of displacement and, with inertia, of velocity anywhere
  // in the body, each divided by the largest such value so far. Collective.
  double distance(State const& a, State const& b, Norm norm);
  DyadicTime const& clock() const { return step_.clock(); }
  fem::FaultSurface const& surface() const { return step_.surface(); }
  [[noreturn]] void throwStepFailure(State const& from, int level) const;

  // The ticks from a time to the next instant; more than any step has if there is none.
  DyadicTime::Ticks ticksLeft(DyadicTime::Ticks time) const;
  // Whether there is a trial and it ends after the next instant.
  bool trialPassesInstant(State const& current) const;
  // Raises the level to `level` if it is lower (larger steps), and remembers the earlier level.
  void shorten(int level);
  // If a step that was cut short to level_before had to be refined further, the size of before is
  // forgotten: after the instant the control goes on with the refined size.
  void noteRefinement(int level_before);
  // If steps were cut short to meet an instant and `current` is at it, restores the earlier level,
  // removes the trial and returns true; otherwise returns false.
  bool resume(State const& current);

  ControlMemory memory_;

  // For the message of a run that fails: why its step was not made smaller, and how it may be.
  struct SizeOfLastStep
  {
    char const* reason;
    char const* cure;
  };

private:
  double distanceInBody(State const& a, State const& b);
  std::string failure(State const& from, int level, std::string const& lost) const;
  virtual SizeOfLastStep sizeOfLastStep() const
  {
    return {"the smallest allowed", "a smaller 'Smallest Step'"};
  }

  CoupledStep& step_;
  std::vector<DyadicTime::Ticks> instants_;
  std::function<std::string(int)> place_of_; // may be empty
  RCP<const Vector> start_;                  // null: zero
  StepStatus last_status_ = StepStatus::solved;
  std::optional<NotFinite> not_finite_; // on this rank, in the last attempt that failed
};
} // namespace asperity::dynamics
