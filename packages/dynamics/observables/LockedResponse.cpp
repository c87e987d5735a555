#include "dynamics/observables/LockedResponse.hpp"

#include "dynamics/initial/WithHeld.hpp"
#include "fem/inelastic/InelasticCells.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <utility>
#include <vector>

namespace asperity::dynamics
{
Body lockedAt(fem::FaultSurface const& surface, Body body)
{
  std::vector<int> dofs;
  for (int node = 0; node < surface.numNodes(); ++node) {
    auto const unknowns = surface.unknownsOf(node);
    dofs.insert(dofs.end(), unknowns.begin(), unknowns.end());
  }
  return withHeld(std::move(body), dofs);
}

LockedResponse::LockedResponse(Body const& body, fem::FaultSurface const& surface,
                               RateSolverSettings const& settings)
    : locked_(lockedAt(surface, body))
    , solver_(locked_, settings)
{
}

RCP<Vector> LockedResponse::toFlow(State const& state)
{
  auto const force = locked_.vector(), relaxed = locked_.vector();
  for (std::size_t k = 0; k < state.branches.size(); ++k) {
    relaxed->update(1, *state.u, -1, *state.branches[k], 0);
    locked_.matrices.branches[k].stiffness->apply(*relaxed, *force, Teuchos::NO_TRANS, 1, 1);
  }
  return solver_.solve(*force);
}

RCP<Vector> LockedResponse::toInelasticStrain(State const& state)
{
  auto const force = locked_.vector();
  locked_.cells->addForces(state.inelastic->strain, *force);
  return solver_.solve(*force);
}
} // namespace asperity::dynamics
