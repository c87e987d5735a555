#include "dynamics/fault/Fault.hpp"

#include "friction/Registry.hpp"

namespace asperity::dynamics
{
namespace
{
FaultProcesses allOf(FaultLaws const& laws)
{
  auto all = laws.processes;
  if (laws.regularisation) {
    all.push_back(laws.regularisation);
  }
  return all;
}
} // namespace

Fault::Fault(std::shared_ptr<const fem::FaultSurface> surface, FaultLaws laws,
             NormalStress normal_stress)
    : surface_(std::move(surface))
    , laws_(std::move(laws))
    , normal_stress_(std::move(normal_stress))
    , processes_(allOf(laws_))
    , friction_(frictionWith(laws_.cohesion))
    , state_(friction::makeStateKernels(laws_.state, laws_.state_parameters, laws_.state_table))
{
}

bool Fault::stateDecides() const
{
  const std::string variable = friction::frictionLaws().at(laws_.friction).state_variable;
  return surface_->numSliding() > 0 && variable != friction::no_state;
}

std::unique_ptr<friction::FrictionKernels> Fault::frictionWith(ConstNodeView const& cohesion) const
{
  return friction::makeFrictionKernels(
    laws_.friction,
    {surface_->weights(), cohesion, surface_->slipFactors(), laws_.friction_parameters});
}
} // namespace asperity::dynamics
