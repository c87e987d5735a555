#pragma once

#include "portability/Views.hpp"

namespace asperity::dynamics
{
// sigma_n := max(sigma_n - p, 0), (num_nodes) [Pa]: what a pressure in the fault leaves friction.
inline void subtractPressure(NodeView const& sigma_n, ConstNodeView const& p)
{
  Kokkos::parallel_for(
    "asperity::dynamics::effectiveStress", RangePolicy(0, sigma_n.extent_int(0)),
    KOKKOS_LAMBDA(int node) {
      sigma_n(node) = sigma_n(node) > p(node) ? sigma_n(node) - p(node) : 0;
    });
}

// sum := sum + p, (num_nodes) [Pa].
inline void addToPressure(ConstNodeView const& p, NodeView const& sum)
{
  Kokkos::parallel_for(
    "asperity::dynamics::sumOfPressures", RangePolicy(0, sum.extent_int(0)),
    KOKKOS_LAMBDA(int node) { sum(node) += p(node); });
}
} // namespace asperity::dynamics
