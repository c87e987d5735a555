#pragma once

#include "base/Views.hpp"

#include <string>

namespace asperity::tnnmg::detail
{
// add(i) for i = 0 ... size - 1, where each may add, by Kokkos::atomic_add, to what others add to,
// too. On the host in the order of i and by one thread, so that sums have the same bits in every
// run; on a device at once.
template <class Add>
void addInOrder(int size, Add const& add)
{
  static const std::string label = "asperity::tnnmg::addInOrder";
  using Policy = Kokkos::RangePolicy<ExecutionSpace>;
  if constexpr (Kokkos::SpaceAccessibility<Kokkos::HostSpace, MemorySpace>::accessible) {
    Kokkos::parallel_for(
      label, Policy(0, 1), KOKKOS_LAMBDA(int) {
        for (int i = 0; i < size; ++i) {
          add(i);
        }
      });
  } else {
    Kokkos::parallel_for(label, Policy(0, size), add);
  }
}
} // namespace asperity::tnnmg::detail
