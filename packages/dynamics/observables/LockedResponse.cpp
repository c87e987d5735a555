#include "dynamics/observables/LockedResponse.hpp"

#include "fem/inelastic/InelasticCells.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>

namespace asperity::dynamics
{
Body lockedAt(fem::FaultSurface const& surface, Body body)
{
  auto const owned = body.vector();
  {
    auto const flags = owned->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (const int dof : body.held.owned()) {
      flags(dof, 0) = 1;
    }
    for (auto const& node : surface) {
      for (const int dof : node.dofs) {
        flags(dof, 0) = 1;
      }
    }
  }
  Vector with_ghosts(body.dofs->overlap());
  body.dofs->shareWithGhosts(*owned, with_ghosts);
  auto const flags = with_ghosts.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<int> held(flags.extent(0));
  for (std::size_t dof = 0; dof < held.size(); ++dof) {
    held[dof] = flags(dof, 0) != 0 ? 1 : 0;
  }
  body.held = fem::HeldDofs(std::move(held), body.numOwnedDofs());
  return body;
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
