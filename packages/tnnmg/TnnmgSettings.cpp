#include "tnnmg/TnnmgSettings.hpp"

#include "parameters/Entries.hpp"

namespace asperity::tnnmg
{
Entries<TnnmgSettings> TnnmgSettings::entries()
{
  return Entries<TnnmgSettings>()
    .real(
      "Absolute Tolerance", &TnnmgSettings::absolute_tolerance, "W^(1/2) m^(-1/2) in 2D",
      Range::atLeast(0),
      "A rate problem counts as solved when the error of the velocity, in the energy norm of Z, "
      "is at most this. It is estimated from the last changes of the velocity.")
    .real("Relative Tolerance", &TnnmgSettings::relative_tolerance, "-", Range::closedOpen(0, 1),
          "This tolerance is relative to the energy norm of the velocity; the larger of it and the "
          "absolute tolerance counts.")
    .integer("Maximum Iterations", &TnnmgSettings::max_iterations, Range::atLeast(1),
             "Once the fixed-point iteration has found alpha, the rate problem is solved in at "
             "most this number of iterations. If they are not enough, the step is rejected.")
    .integer("Sweeps", &TnnmgSettings::sweeps, Range::atLeast(1),
             "Each iteration makes this number of nonlinear Gauss-Seidel sweeps over the fault.")
    .real("Correction Tolerance", &TnnmgSettings::correction_tolerance, "-", Range::open(0, 1),
          "The linear correction is solved until its relative residual is at most this.")
    .real("Stiff Node", &TnnmgSettings::stiff, "-", Range::positive(),
          "A node is truncated, and moved by Gauss-Seidel alone, if its friction Hessian exceeds "
          "this multiple of Z's diagonal.");
}
} // namespace asperity::tnnmg
