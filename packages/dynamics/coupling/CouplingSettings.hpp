#pragma once

#include "dynamics/fault/Norm.hpp"

#include <Teuchos_ParameterList.hpp>

namespace asperity::dynamics
{
// The deck's list `Coupling`: the fixed-point iteration of a step.
struct CouplingSettings
{
  double tolerance = 1e-5; // of alpha between two iterates
  Norm norm = Norm::root_mean_square;
  int max_iterations = 100;
  int anderson_depth = 2;

  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  // step_tolerance: of the step control, from which the default follows; 0 if it has none.
  static CouplingSettings from(Teuchos::ParameterList const& parameters, double step_tolerance);
};
} // namespace asperity::dynamics
