#include "tnnmg/TnnmgSettings.hpp"

#include "base/parameters/Parameters.hpp"

namespace asperity::tnnmg
{
Teuchos::RCP<Teuchos::ParameterList> TnnmgSettings::validParameters()
{
  const TnnmgSettings defaults;
  return Declare()
    .real("Absolute Tolerance", defaults.absolute_tolerance, "W^(1/2) m^(-1/2) in 2D",
          Range::atLeast(0),
          "Energy norm of Z of the last change of the velocity at which a rate problem is solved.")
    .real("Relative Tolerance", defaults.relative_tolerance, "-", Range::atLeast(0),
          "The same, relative to the energy norm of the velocity; the larger of the two counts.")
    .integer("Maximum Iterations", defaults.max_iterations, Range::atLeast(1),
             "Iterations after which the rate problem of a state at rest counts as failed, which "
             "rejects the step.")
    .integer("Sweeps", defaults.sweeps, Range::atLeast(1),
             "Nonlinear Gauss-Seidel sweeps over the fault in each iteration.")
    .real("Correction Tolerance", defaults.correction_tolerance, "-", Range::open(0, 1),
          "Relative residual to which the linear correction is solved.")
    .real("Stiff Node", defaults.stiff, "-", Range::positive(),
          "A node whose friction Hessian exceeds this multiple of Z's diagonal is left to "
          "Gauss-Seidel.")
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
