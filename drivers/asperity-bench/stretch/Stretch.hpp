#pragma once

#include "base/parameters/Parameters.hpp"
#include "dynamics/control/StepControl.hpp"
#include "dynamics/coupling/CoupledStep.hpp"
#include "scenario/Problem.hpp"

#include <memory>

// The first accepted steps of a three-dimensional deck, without outputs. A step is inertial if the
// body has a mass and the slowest shear wave goes through less than the body's longest side during
// the step; otherwise it is quasi-static.
class Stretch
{
public:
  // `deck` must be complete. Collective.
  Stretch(asperity::ParameterList const& deck,
          asperity::RCP<const asperity::Communicator> const& communicator);

  asperity::scenario::Problem<3> const& problem() const { return problem_; }
  asperity::dynamics::RateUpdate const& update() const { return update_; }
  asperity::dynamics::CoupledStep& step() { return step_; }
  long long numUnknowns() const;
  bool isInertial(double step_size) const { return step_size < crossing_time_; } // s

  // One accepted step further; returns its level in the clock. Collective.
  int advance();
  asperity::dynamics::State const& state() const { return state_; }
  asperity::dynamics::SolveCount const& count() const { return count_; } // from the beginning

private:
  asperity::scenario::Problem<3> problem_;
  asperity::dynamics::RateUpdate update_;
  asperity::dynamics::CoupledStep step_;
  std::unique_ptr<asperity::dynamics::StepControl> control_;
  asperity::dynamics::State state_;
  asperity::dynamics::SolveCount count_;
  double crossing_time_; // s
};
