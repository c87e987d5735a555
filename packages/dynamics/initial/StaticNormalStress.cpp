#include "dynamics/initial/StaticNormalStress.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity::dynamics
{
std::vector<double> staticNormalStress(Body const& body, fem::NodalFrames const& frames,
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
  std::vector<double> normal_stress;
  for (int i = 0; i < surface.numNodes(); ++i) {
    std::array<double, 3> normal{};
    frames.toFrame(surface.vertex(i), surface[i].normal.data(), normal.data());
    double outward = 0; // load - K u along the outward normal
    for (int c = 0; c < components; ++c) {
      outward += values(body.dofs->dof(surface.vertex(i), c), 0) * normal[c];
    }
    normal_stress.push_back(outward / support[i]);
  }
  return normal_stress;
}
} // namespace asperity::dynamics
