#pragma once

#include "dynamics/initial/Model.hpp"
#include "fem/NodalDamping.hpp"
#include "unit/dynamics/SmallModel.hpp"

namespace asperity::dynamics::test
{
// A body without its mass, and with radiation damping on its fault; at rest.
inline dynamics::Model quasiDynamic(dynamics::test::Model const& model)
{
  dynamics::Model result{
    model.body,
    dynamics::Fault(model.surface, model.fault.laws(), model.fault.normalStress()),
    model.restingState(),
    {}};
  auto& matrices = result.body.matrices;
  matrices.mass = fem::zeroLike(*matrices.mass);
  matrices.is_massless = true;
  const std::vector<double> eta(model.surface->numNodes(), 30.);
  matrices.viscosity = fem::withDampers(*matrices.viscosity, *model.dofs,
                                        fem::radiationDampers(*model.surface, *model.dofs, eta));
  return result;
}
} // namespace asperity::dynamics::test
