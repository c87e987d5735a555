#include "BenchKernels.hpp"

namespace asperity::bench
{
void addTriad(NodeView const& a, NodeView const& b, NodeView const& c)
{
  Kokkos::parallel_for(
    "asperity::bench::triad", RangePolicy(0, a.extent_int(0)),
    KOKKOS_LAMBDA(int i) { a(i) = b(i) + 3 * c(i); });
}

void addForce(ConstNodeView const& curvature, double v, BlockView const& r)
{
  Kokkos::parallel_for(
    "asperity::bench::force", RangePolicy(0, r.extent_int(0)),
    KOKKOS_LAMBDA(int node) { r(node, 0) += curvature(node) * v; });
}
} // namespace asperity::bench
