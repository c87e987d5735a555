#include "dynamics/coupling/CouplingSettings.hpp"

#include "parameters/Entries.hpp"

#include <algorithm>

namespace asperity::dynamics
{
namespace
{
Entries<CouplingSettings> couplingEntries()
{
  CouplingSettings defaults;
  defaults.tolerance = 0; // follows from the step control
  return Entries<CouplingSettings>(defaults)
    .real("Tolerance", &CouplingSettings::tolerance, "-", Range::closedOpen(0, 1),
          "The fixed-point iteration of rate and state ends when alpha changes by at most this "
          "between two iterates, in the norm chosen. 0 means a thousandth of the Tolerance of the "
          "step control, but at most 1e-5, which also holds for prescribed steps.")
    .choice("Norm", &CouplingSettings::norm, normWords(),
            "Selects how that change is measured over the fault. Maximum also responds to a "
            "nucleation much smaller than the fault, which has little weight in a mean.")
    .integer("Maximum Iterations", &CouplingSettings::max_iterations, Range::atLeast(1),
             "A step is rejected after this number of fixed-point iterations. The step control "
             "then halves it; a run with prescribed steps ends.")
    .integer("Anderson Depth", &CouplingSettings::anderson_depth, Range::atLeast(0),
             "Anderson acceleration extrapolates the next iterate from this number of earlier "
             "ones; 0 means the plain fixed-point iteration.");
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> CouplingSettings::validParameters()
{
  return couplingEntries().list();
}

CouplingSettings CouplingSettings::from(Teuchos::ParameterList const& parameters,
                                        double step_tolerance)
{
  constexpr double share_of_steps = 1e-3;
  auto settings = couplingEntries().read(parameters, "Asperity / Coupling");
  if (settings.tolerance == 0) {
    settings.tolerance = CouplingSettings().tolerance;
    if (step_tolerance > 0) {
      settings.tolerance = std::min(settings.tolerance, share_of_steps * step_tolerance);
    }
  }
  return settings;
}
} // namespace asperity::dynamics
