#pragma once

#include "portability/Views.hpp"

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace asperity::multigrid
{
template <class Space>
using FloatView = Kokkos::View<float*, Kokkos::LayoutRight, Space>;

// Local vectors, node after node; vectors on columns have the ghosts at their end. Blocks lie in
// the order of the couplings, row by row, in single precision: the matrices of a preconditioner,
// whose cost is the memory that they read. A product with single blocks reads a third of what a
// sparse matrix of scalars needs.
using NodeVector = FloatView<MemorySpace>;
using NodeBlocks = FloatView<MemorySpace>;
using HostBlocks = FloatView<Kokkos::HostSpace>; // where kernels run on the host, NodeBlocks

// Zeros, with more of them behind the last, so that four lanes may be loaded from any place.
template <class View = NodeVector>
View makeNumbers(std::size_t size)
{
  constexpr std::size_t padding = 4;
  const View all("asperity::multigrid::numbers", size + padding);
  return Kokkos::subview(all, std::make_pair(std::size_t(0), size));
}

inline IndexView indices(std::vector<int> const& host)
{
  return toDevice(host, "asperity::multigrid::indices");
}

// The same numbers where kernels run; no copy if that is the host.
template <class Space = MemorySpace>
FloatView<Space> onDevice(HostBlocks const& host)
{
  if constexpr (std::is_same<Space, Kokkos::HostSpace>::value) {
    return host;
  } else {
    const auto device = makeNumbers<FloatView<Space>>(host.extent(0));
    Kokkos::deep_copy(device, host);
    return device;
  }
}
} // namespace asperity::multigrid
