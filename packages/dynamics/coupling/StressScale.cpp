#include "dynamics/coupling/StressScale.hpp"

#include "base/parallel/Reductions.hpp"

#include <algorithm>

namespace asperity::dynamics
{
namespace
{
constexpr double small_share = 1e-2; // relative changes of a stress near zero do not matter

double largest(ConstNodeView const& values)
{
  double result = 0;
  Kokkos::parallel_reduce(
    "asperity::dynamics::largestNormalStress", RangePolicy(0, values.extent(0)),
    KOKKOS_LAMBDA(int node, double& maximum) {
      maximum = maximum < values(node) ? values(node) : maximum;
    },
    Kokkos::Max<double>(result));
  return std::max(result, 0.); // a rank without nodes has no maximum
}
} // namespace

void setScaleOfStress(ConstNodeView const& stress, fem::FaultSurface const& surface,
                      NodeView const& scale)
{
  const double most = maxOverRanks(largest(stress), *surface.communicator());
  const double least = most > 0 ? small_share * most : 1;
  Kokkos::parallel_for(
    "asperity::dynamics::scaleOfNormalStress", RangePolicy(0, scale.extent(0)),
    KOKKOS_LAMBDA(int node) { scale(node) = scaleOfStress(stress(node), least); });
}
} // namespace asperity::dynamics
