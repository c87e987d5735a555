#include "dynamics/Fault.hpp"

#include "friction/Registry.hpp"

namespace asperity::dynamics
{
Fault::Fault(std::shared_ptr<const fem::FaultSurface> surface, FaultLaws laws,
             NormalStress normal_stress)
    : surface_(std::move(surface))
    , laws_(std::move(laws))
    , normal_stress_(std::move(normal_stress))
    , friction_(frictionWith(laws_.cohesion))
    , state_(friction::makeStateKernels(laws_.state, laws_.state_parameters))
{
}

std::unique_ptr<friction::FrictionKernels>
Fault::frictionWith(friction::ConstNodeView const& cohesion) const
{
  return friction::makeFrictionKernels(
    laws_.friction,
    {surface_->weights(), cohesion, surface_->slipFactors(), laws_.friction_parameters});
}
} // namespace asperity::dynamics
