#include "dynamics/initial/FoundationPressure.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity::dynamics
{
std::vector<double> foundationPressure(Body const& body, fem::NodalFrames const& frames,
                                       fem::FaultSurface const& surface,
                                       std::vector<double> const& support, Vector const& load,
                                       Vector const& u)
{
  auto const rest = body.vector(), unbalanced = body.vector();
  const std::vector<RCP<Vector>> branches(body.matrices.branches.size(),
                                          rcp(new Vector(u, Teuchos::Copy)));
  body.residual(load, {u, *rest, *rest, branches}, *unbalanced);
  auto const values = unbalanced->getLocalViewHost(Tpetra::Access::ReadOnly);
  const int components = body.dofs->components();
  std::vector<double> pressure;
  for (int i = 0; i < surface.numNodes(); ++i) {
    std::array<double, 3> normal{};
    frames.toFrame(surface.vertex(i), surface[i].normal.data(), normal.data());
    double outward = 0;
    for (int c = 0; c < components; ++c) {
      outward += values(body.dofs->dof(surface.vertex(i), c), 0) * normal[c];
    }
    pressure.push_back(outward / support[i]);
  }
  return pressure;
}
} // namespace asperity::dynamics
