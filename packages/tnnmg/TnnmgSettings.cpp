#include "tnnmg/TnnmgSettings.hpp"

#include "parameters/Parameters.hpp"

namespace asperity::tnnmg
{
Teuchos::RCP<Teuchos::ParameterList> TnnmgSettings::validParameters()
{
  const TnnmgSettings defaults;
  return Declare()
    .real(
      "Absolute Tolerance", defaults.absolute_tolerance, "W^(1/2) m^(-1/2) in 2D",
      Range::atLeast(0),
      "A rate problem counts as solved when the error of the velocity, in the energy norm of Z, "
      "is at most this. It is estimated from the last changes of the velocity.")
    .real("Relative Tolerance", defaults.relative_tolerance, "-", Range::closedOpen(0, 1),
          "This tolerance is relative to the energy norm of the velocity; the larger of it and the "
          "absolute tolerance counts.")
    .integer("Maximum Iterations", defaults.max_iterations, Range::atLeast(1),
             "Once the fixed-point iteration has found alpha, the rate problem is solved in at "
             "most this number of iterations. If they are not enough, the step is rejected.")
    .integer("Sweeps", defaults.sweeps, Range::atLeast(1),
             "Each iteration makes this number of nonlinear Gauss-Seidel sweeps over the fault.")
    .real("Correction Tolerance", defaults.correction_tolerance, "-", Range::open(0, 1),
          "The linear correction is solved until its relative residual is at most this.")
    .real("Stiff Node", defaults.stiff, "-", Range::positive(),
          "A node is truncated, and moved by Gauss-Seidel alone, if its friction Hessian exceeds "
          "this multiple of Z's diagonal.")
    .list();
}

TnnmgSettings TnnmgSettings::from(Teuchos::ParameterList const& parameters)
{
  TnnmgSettings settings;
  settings.absolute_tolerance = parameters.get<double>("Absolute Tolerance");
  settings.relative_tolerance = parameters.get<double>("Relative Tolerance");
  settings.max_iterations = parameters.get<int>("Maximum Iterations");
  settings.sweeps = parameters.get<int>("Sweeps");
  settings.correction_tolerance = parameters.get<double>("Correction Tolerance");
  settings.stiff = parameters.get<double>("Stiff Node");
  return settings;
}
} // namespace asperity::tnnmg
