#pragma once

#include "dynamics/control/AdaptiveSettings.hpp"
#include "dynamics/control/StepControlKind.hpp"

namespace asperity::dynamics
{
// Makes steps in pairs. One step of twice the size is compared with the pair, and the pair is kept:
// two of three coupled steps are accepted. With a scheme of order p the error of the pair is about
//
//   |alpha(one step) - alpha(two steps)| / (2^p - 1)
//
// (Richardson's extrapolation; Hairer, Norsett and Wanner 1993, II.4). The largest error of alpha
// and the other unknowns of a step (CoupledStep::distance) and of waves has to meet the tolerance.
// Twice the step size means 2^(p+1) times the error. So the size of the next pair is
// predicted from the last error and its trend, instead of being found by trial.
//
// The first guess of the pair comes from the step of twice the size, unless that is far from the
// straight line through the states before. Where a rupture begins, a step that is too long may have
// a second solution in which the fault has ruptured already, or only that one. Guesses from such a
// solution lead shorter steps to their own second solutions, down to the shortest that has one.
class RichardsonControl final : public StepControl
{
public:
  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  static std::string meaning();
  // A restart may change all: they decide on the steps to come alone.
  static bool mayChange(std::string const&) { return true; }
  static std::string toleranceEntry() { return "Tolerance"; }

  // Throws InputError where no step is twice as large as another.
  RichardsonControl(Teuchos::ParameterList const& parameters, ControlContext const& context);
  RichardsonControl(ControlContext const& context, AdaptiveSettings const& settings);
  AcceptedStep advance(State& current, SolveCount& count) override;
  void save(Archive& archive, StateArchive const& states) const override;
  void restore(Archive const& archive, StateArchive const& states) override;
  void adaptToClock() override;

  // What it remembers in addition to the memory of every control: the state in which the last pair
  // of steps began, and its level; the error of that pair, and of the pair before, scaled to steps
  // of the same size (0: unknown).
  struct LastPair
  {
    std::optional<State> before;
    int level = 0;
    double error = 0, previous_error = 0;
  };
  LastPair const& lastPair() const { return last_; }

private:
  struct Pair
  {
    std::optional<Trial> first, second; // empty: not solved
    double error = 0;                   // infinite if there is nothing to compare with
  };
  // The straight line from the beginning of the last pair through `current`, extended by `steps`
  // steps of level memory_.level.
  Guess extrapolated(State const& current, double steps) const;
  // One step from the present state to the end of a pair of steps of level memory_.level, at the
  // fault alone.
  std::optional<State> wholeStep(State const& current, SolveCount& count);
  bool isNearStraightLine(State const& current, State const& end) const;
  Pair pairOf(State const& current, std::optional<State> const& whole, SolveCount& count);
  Pair acceptablePair(State const& current, SolveCount& count);
  void predictLevel(double error);
  AcceptedStep firstOfPair(State& current, SolveCount& count);
  AcceptedStep secondOfPair(State& current);
  // Takes the last tick before an instant, into which no pair fits.
  AcceptedStep singleStep(State& current, SolveCount& count);

  LastPair last_;
  AdaptiveSettings settings_;
  double extrapolation_; // 2^p - 1
  double error_ratio_;   // 2^(p+1), from one level to the next
  WaveError waves_;
};
} // namespace asperity::dynamics
