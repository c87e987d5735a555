#include "rate_problems/FrictionForces.hpp"

#include "dynamics/FaultMotion.hpp"

#include <Tpetra_Vector.hpp>

using namespace asperity;

void addFrictionForces(fem::FaultSurface const& surface, dynamics::FrictionProblem const& friction,
                       Vector const& v, Vector& b)
{
  const int num_nodes = surface.numNodes(), size = surface.numTangents();
  const friction::BlockView at_nodes("asperity::bench::v", num_nodes, size);
  const friction::BlockView gradient("asperity::bench::gradient", num_nodes, size);
  const friction::HessianView hessian("asperity::bench::hessian", num_nodes, size, size);
  const friction::FlagView kinked("asperity::bench::kinked", num_nodes);
  dynamics::gather(surface, v, at_nodes);
  friction.linearise(at_nodes, gradient, hessian, kinked);
  auto const values = b.getLocalViewHost(Tpetra::Access::ReadWrite);
  auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), gradient);
  for (int node = 0; node < num_nodes; ++node) {
    for (int k = 0; k < size; ++k) {
      values(surface[node].dofs[k], 0) += host(node, k);
    }
  }
}
