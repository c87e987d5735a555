#include "dynamics/FaultMotion.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::dynamics
{
namespace
{
// A plate rate along the fault has components of this share across a wall by rounding.
constexpr double rounding = 1e-9;

double plateSpeed(fem::FaultSurface const& surface, int node)
{
  double square = 0;
  for (int k = 0; k < surface.numTangents(); ++k) {
    square += surface.plateRate(node, k) * surface.plateRate(node, k);
  }
  return std::sqrt(square);
}
} // namespace

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
      const double slip_rate = surface.slipFactor() * values(dof, 0) + surface.plateRate(node, k);
      ASPERITY_REQUIRE(
        !surface.held(node, k) || std::abs(slip_rate) <= rounding * plateSpeed(surface, node),
        "At vertex " << prescribed_velocity.getMap()->getGlobalElement(dof) / components
                     << " of the fault one tangential velocity is prescribed as " << values(dof, 0)
                     << " m/s at t = " << t << " s"
                     << (surface.hasPlateRate() ? ", which is slip beside the plate rate," : ",")
                     << " and the other one is left to friction. Prescribe zero (a wall that "
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

std::vector<double> slipUnknowns(fem::FaultSurface const& surface, Vector const& v)
{
  auto const values = v.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<double> result;
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int k = 0; k < surface.numTangents(); ++k) {
      const double of_body = values(surface[node].dofs[k], 0);
      result.push_back(surface.hasPlateRate()
                         ? of_body + surface.plateRate(node, k) / surface.slipFactor()
                         : of_body);
    }
  }
  return result;
}

void gatherSlip(fem::FaultSurface const& surface, Vector const& v,
                friction::BlockView const& blocks)
{
  auto const slip = slipUnknowns(surface, v);
  auto const host = Kokkos::create_mirror_view(blocks);
  for (std::size_t i = 0; i < slip.size(); ++i) {
    host(i / surface.numTangents(), i % surface.numTangents()) = slip[i];
  }
  Kokkos::deep_copy(blocks, host);
}

void stickToPlates(fem::FaultSurface const& surface, Vector& v)
{
  if (!surface.hasPlateRate()) {
    return;
  }
  auto const values = v.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int k = 0; k < surface.numTangents(); ++k) {
      if (!surface.held(node, k)) {
        values(surface[node].dofs[k], 0) = -surface.plateRate(node, k) / surface.slipFactor();
      }
    }
  }
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
  auto const slip = slipUnknowns(surface, v);
  double mine = 0;
  for (int node = 0; node < surface.numNodes(); ++node) {
    if (!surface.slides(node)) {
      continue;
    }
    double magnitude = 0;
    for (int k = 0; k < surface.numTangents(); ++k) {
      magnitude = std::hypot(magnitude, slip[node * surface.numTangents() + k]);
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
