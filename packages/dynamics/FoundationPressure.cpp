#include "dynamics/FoundationPressure.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity::dynamics
{
std::vector<double> foundationPressure(Body const& body, fem::NodalFrames const& frames,
                                       fem::FaultSurface const& surface,
                                       std::vector<double> const& support, Vector const& load,
                                       Vector const& u)
{
  Vector reaction(load, Teuchos::Copy);
  body.matrices.stiffness->apply(u, reaction, Teuchos::NO_TRANS, 1, -1);
  auto const along_axes = fem::alongAxes(frames, *body.dofs, reaction);
  const int components = body.dofs->components();
  std::vector<double> pressure;
  for (int i = 0; i < surface.numNodes(); ++i) {
    double outward = 0;
    for (int d = 0; d < components; ++d) {
      outward += along_axes[components * surface.vertex(i) + d] * surface[i].normal[d];
    }
    pressure.push_back(-outward / support[i]);
  }
  return pressure;
}
} // namespace asperity::dynamics
