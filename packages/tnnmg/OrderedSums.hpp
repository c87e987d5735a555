#pragma once

#include "base/Views.hpp"

#include <string>

namespace asperity::tnnmg::detail
{
// Calls add(i) for i = 0 ... size - 1; several calls may add to the same place, by
// Kokkos::atomic_add. On the host one thread makes the calls in the order of i, so that sums have
// the same bits in every run; on a device they run at the same time.
template <class Add>
void addInOrder(int size, Add const& add)
{
  static const std::string label = "asperity::tnnmg::addInOrder";
  if constexpr (Kokkos::SpaceAccessibility<Kokkos::HostSpace, MemorySpace>::accessible) {
    Kokkos::parallel_for(
      label, RangePolicy(0, 1), KOKKOS_LAMBDA(int) {
        for (int i = 0; i < size; ++i) {
          add(i);
        }
      });
  } else {
    Kokkos::parallel_for(label, RangePolicy(0, size), add);
  }
}
} // namespace asperity::tnnmg::detail
