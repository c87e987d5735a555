#include "dynamics/initial/WithHeld.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_Vector.hpp>

#include <utility>

namespace asperity::dynamics
{
Body withHeld(Body body, std::vector<int> const& dofs)
{
  auto const owned = body.vector();
  {
    auto const flags = owned->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (const int dof : body.held.owned()) {
      flags(dof, 0) = 1;
    }
    for (const int dof : dofs) {
      flags(dof, 0) = 1;
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
} // namespace asperity::dynamics
