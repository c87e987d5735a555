#include "dynamics/coupling/StressScale.hpp"

#include "base/parallel/Reductions.hpp"
#include "dynamics/fault/FaultMotion.hpp"

namespace asperity::dynamics
{
namespace
{
constexpr double small_share = 1e-2; // relative changes of a stress near zero do not matter
} // namespace

void setScaleOfStress(ConstNodeView const& stress, fem::FaultSurface const& surface,
                      NodeView const& scale)
{
  const double most = maxOverRanks(largestOf(stress), *surface.communicator());
  const double least = most > 0 ? small_share * most : 1;
  Kokkos::parallel_for(
    "asperity::dynamics::scaleOfNormalStress", RangePolicy(0, scale.extent(0)),
    KOKKOS_LAMBDA(int node) { scale(node) = scaleOfStress(stress(node), least); });
}
} // namespace asperity::dynamics
