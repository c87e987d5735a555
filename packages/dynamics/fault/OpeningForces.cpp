#include "dynamics/fault/OpeningForces.hpp"

#include "base/Errors.hpp"

#include <Tpetra_Vector.hpp>

namespace asperity::dynamics
{
OpeningForces::OpeningForces(Fault const& fault, ReactionSinceStart const& since_start)
    : fault_(fault)
    , since_start_(since_start)
    , sigma_0_("asperity::dynamics::sigma0", fault.surface().numNodes())
    , pressure_("asperity::dynamics::fluidPressure", fault.surface().numNodes())
    , stress_("asperity::dynamics::stressAcross", fault.surface().numNodes())
{
  ASPERITY_ASSERT(fault.surface().mayOpen() && since_start_.reaction);
}

void OpeningForces::evaluate(double t) { fault_.normalStress().at(t, sigma_0_); }

void OpeningForces::add(State const& state, Vector& b) const
{
  Kokkos::deep_copy(pressure_, 0.);
  for (auto const& process : fault_.processes()) {
    process->addPressure(state, pressure_);
  }
  auto const sigma_0 = sigma_0_, p = pressure_, stress = stress_;
  auto const start = since_start_.at_start;
  auto const opens = fault_.surface().openingNodes();
  Kokkos::parallel_for(
    "asperity::dynamics::stressAcross", RangePolicy(0, stress.extent_int(0)),
    KOKKOS_LAMBDA(int node) {
      stress(node) = opens(node) ? sigma_0(node) - start(node) - p(node) : 0;
    });
  since_start_.reaction->addCompression(stress, b);
}

NodeView openingOf(fem::FaultSurface const& surface, Vector const& u)
{
  const NodeView result("asperity::dynamics::opening", surface.numNodes());
  auto const values = u.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const opens = surface.openingNodes();
  auto const across = surface.dofsAcross();
  auto const sign = surface.openingSigns();
  Kokkos::parallel_for(
    "asperity::dynamics::openingOf", RangePolicy(0, opens.extent_int(0)), KOKKOS_LAMBDA(int node) {
      result(node) = opens(node) ? sign(node) * values(across(node), 0) : 0;
    });
  return result;
}
} // namespace asperity::dynamics
