#include "dynamics/FaultMotion.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::dynamics
{
void requireRestBesideSliding(fem::FaultSurface const& surface, Vector const& prescribed_velocity,
                              int components, double t)
{
  auto const values = prescribed_velocity.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int node = 0; node < surface.numNodes(); ++node) {
    if (!surface.slides(node)) {
      continue;
    }
    for (int k = 0; k < surface.numTangents(); ++k) {
      const int dof = surface[node].dofs[k];
      ASPERITY_REQUIRE(
        !surface.held(node, k) || values(dof, 0) == 0,
        "At vertex " << prescribed_velocity.getMap()->getGlobalElement(dof) / components
                     << " of the fault one tangential velocity is prescribed as " << values(dof, 0)
                     << " m/s at t = " << t
                     << " s, and the other one is left to friction. Prescribe zero (a wall that "
                        "the fault ends at), or both.");
    }
  }
}

void gather(fem::FaultSurface const& surface, Vector const& v, friction::BlockView const& blocks)
{
  auto const values = v.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const host = Kokkos::create_mirror_view(blocks);
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int k = 0; k < surface.numTangents(); ++k) {
      host(node, k) = values(surface[node].dofs[k], 0);
    }
  }
  Kokkos::deep_copy(blocks, host);
}

void slipRate(fem::FaultSurface const& surface, friction::ConstBlockView const& v,
              friction::NodeView const& V)
{
  const int size = surface.numTangents();
  const double factor = surface.slipFactor();
  Kokkos::parallel_for(
    "asperity::dynamics::slipRate",
    Kokkos::RangePolicy<friction::ExecutionSpace>(0, surface.numNodes()), KOKKOS_LAMBDA(int node) {
      double largest = 0;
      for (int k = 0; k < size; ++k) {
        const double magnitude = v(node, k) < 0 ? -v(node, k) : v(node, k);
        largest = largest > magnitude ? largest : magnitude;
      }
      // In units of the largest component, since the square of a slow rate underflows.
      double square = 0;
      for (int k = 0; k < size && largest > 0; ++k) {
        square += (v(node, k) / largest) * (v(node, k) / largest);
      }
      V(node) = factor * (size == 1 ? largest : largest * Kokkos::Experimental::sqrt(square));
    });
}

double peakSlipRate(fem::FaultSurface const& surface, Vector const& v)
{
  auto const values = v.getLocalViewHost(Tpetra::Access::ReadOnly);
  double mine = 0;
  for (int node = 0; node < surface.numNodes(); ++node) {
    if (!surface.slides(node)) {
      continue;
    }
    double magnitude = 0;
    for (int dof : surface[node].dofs) {
      magnitude = std::hypot(magnitude, values(dof, 0));
    }
    mine = std::max(mine, surface.slipFactor() * magnitude);
  }
  return maxOverRanks(mine, *surface.communicator());
}

double distance(fem::FaultSurface const& surface, friction::ConstNodeView const& a,
                friction::ConstNodeView const& b, Norm norm)
{
  auto const weight = surface.weights();
  double mine = 0;
  const bool largest = norm == Norm::maximum;
  auto const nodes = Kokkos::RangePolicy<friction::ExecutionSpace>(0, surface.numNodes());
  if (largest) {
    // Not a number counts as infinitely far, which a maximum would overlook.
    Kokkos::parallel_reduce(
      "asperity::dynamics::maximumDistance", nodes,
      KOKKOS_LAMBDA(int node, double& maximum) {
        const double difference = a(node) < b(node) ? b(node) - a(node) : a(node) - b(node);
        maximum = difference <= maximum ? maximum : difference >= 0 ? difference : INFINITY;
      },
      Kokkos::Max<double>(mine));
  } else {
    Kokkos::parallel_reduce(
      "asperity::dynamics::distance", nodes,
      KOKKOS_LAMBDA(int node, double& sum) {
        const double difference = a(node) - b(node);
        sum += weight(node) * difference * difference;
      },
      mine);
  }
  if (largest) { // a rank without nodes has no maximum
    return maxOverRanks(std::max(mine, 0.), *surface.communicator());
  }
  return std::sqrt(sumOverRanks(mine, *surface.communicator()) / surface.totalWeight());
}
} // namespace asperity::dynamics
