#include "dynamics/Fault.hpp"

#include <Teuchos_CommHelpers.hpp>
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

void Fault::slipRate(friction::ConstBlockView const& v0, friction::ConstBlockView const& v1,
                     double lambda, friction::NodeView const& V) const
{
  const int size = num_tangents;
  const double factor = slip_factor;
  Kokkos::parallel_for(
    "asperity::dynamics::slipRate", Kokkos::RangePolicy<friction::ExecutionSpace>(0, numNodes()),
    KOKKOS_LAMBDA(int node) {
      double largest = 0;
      for (int k = 0; k < size; ++k) {
        const double v = lambda * v0(node, k) + (1 - lambda) * v1(node, k);
        largest = largest > (v < 0 ? -v : v) ? largest : (v < 0 ? -v : v);
      }
      // In units of the largest component, since the square of a slow rate underflows.
      double square = 0;
      for (int k = 0; k < size && largest > 0; ++k) {
        const double v = (lambda * v0(node, k) + (1 - lambda) * v1(node, k)) / largest;
        square += v * v;
      }
      V(node) = factor * (size == 1 ? largest : largest * Kokkos::Experimental::sqrt(square));
    });
}

double Fault::peakSlipRate(Vector const& v) const
{
  auto const values = v.getLocalViewHost(Tpetra::Access::ReadOnly);
  double mine = 0;
  for (auto const& node : dofs) {
    double magnitude = 0;
    for (int dof : node) {
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

double Fault::distance(friction::ConstNodeView const& a, friction::ConstNodeView const& b) const
{
  auto const weight = data.weight;
  double mine = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::distance", Kokkos::RangePolicy<friction::ExecutionSpace>(0, numNodes()),
    KOKKOS_LAMBDA(int node, double& sum) {
      const double difference = a(node) - b(node);
      sum += weight(node) * difference * difference;
    },
    mine);
  double all = mine;
  if (communicator->getSize() > 1) {
    Teuchos::reduceAll(*communicator, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  }
  return std::sqrt(all / total_weight);
}
} // namespace asperity::dynamics
