#include "dynamics/Fault.hpp"

#include "base/Errors.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::dynamics
{
int Fault::sumOverRanks(int value) const
{
  int sum = value;
  if (communicator->getSize() > 1) {
    Teuchos::reduceAll(*communicator, Teuchos::REDUCE_SUM, value, Teuchos::outArg(sum));
  }
  return sum;
}

bool Fault::slides(int node) const
{
  return std::find(fixed[node].begin(), fixed[node].end(), 0) != fixed[node].end();
}

void Fault::requireWalls(Vector const& prescribed_velocity, int components, double t) const
{
  auto const values = prescribed_velocity.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int node = 0; node < numNodes(); ++node) {
    if (!slides(node)) {
      continue;
    }
    for (int k = 0; k < num_tangents; ++k) {
      const int dof = dofs[node][k];
      ASPERITY_REQUIRE(
        !fixed[node][k] || values(dof, 0) == 0,
        "At vertex " << prescribed_velocity.getMap()->getGlobalElement(dof) / components
                     << " of the fault one tangential velocity is prescribed as " << values(dof, 0)
                     << " m/s at t = " << t
                     << " s, and the other one is left to friction. Prescribe zero (a wall that "
                        "the fault ends at), or both.");
    }
  }
}

void Fault::gather(Vector const& v, friction::BlockView const& blocks) const
{
  auto const values = v.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const host = Kokkos::create_mirror_view(blocks);
  for (int node = 0; node < numNodes(); ++node) {
    for (int k = 0; k < num_tangents; ++k) {
      host(node, k) = values(dofs[node][k], 0);
    }
  }
  Kokkos::deep_copy(blocks, host);
}

void Fault::slipRate(friction::ConstBlockView const& v, friction::NodeView const& V) const
{
  const int size = num_tangents;
  const double factor = slip_factor;
  Kokkos::parallel_for(
    "asperity::dynamics::slipRate", Kokkos::RangePolicy<friction::ExecutionSpace>(0, numNodes()),
    KOKKOS_LAMBDA(int node) {
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

void Fault::setTime(double t) const
{
  if (normal_stress_at) {
    normal_stress_at(t, normal_stress);
  }
}

double Fault::peakSlipRate(Vector const& v) const
{
  auto const values = v.getLocalViewHost(Tpetra::Access::ReadOnly);
  double mine = 0;
  for (int node = 0; node < numNodes(); ++node) {
    if (!slides(node)) {
      continue;
    }
    double magnitude = 0;
    for (int dof : dofs[node]) {
      magnitude = std::hypot(magnitude, values(dof, 0));
    }
    mine = std::max(mine, slip_factor * magnitude);
  }
  double all = mine;
  if (communicator->getSize() > 1) {
    Teuchos::reduceAll(*communicator, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(all));
  }
  return all;
}

double Fault::distance(friction::ConstNodeView const& a, friction::ConstNodeView const& b,
                       Norm norm) const
{
  auto const weight = data.weight;
  double mine = 0;
  const bool largest = norm == Norm::maximum;
  auto const nodes = Kokkos::RangePolicy<friction::ExecutionSpace>(0, numNodes());
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
  mine = largest ? std::max(mine, 0.) : mine; // a rank without nodes has no maximum
  double all = mine;
  if (communicator->getSize() > 1) {
    Teuchos::reduceAll(*communicator, largest ? Teuchos::REDUCE_MAX : Teuchos::REDUCE_SUM, mine,
                       Teuchos::outArg(all));
  }
  return largest ? all : std::sqrt(all / total_weight);
}
} // namespace asperity::dynamics
