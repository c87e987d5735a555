#pragma once

#include "base/Types.hpp"
#include "portability/Spaces.hpp"

#include <Kokkos_Core.hpp>

#include <string>
#include <vector>

// Kokkos views of what the parts of a solver share about nodes, and the ways to and from the host.
namespace asperity
{
// Any number of local rows, columns or nodes.
using IndexView = Kokkos::View<const int*, MemorySpace>;
// One flag for each local row or node: 0 or 1.
using ConstFlagView = Kokkos::View<const int*, MemorySpace>;
// (num_nodes, T): the local dofs of T components at each node.
using NodeDofView = Kokkos::View<const LocalOrdinal**, Kokkos::LayoutRight, MemorySpace>;

// A copy on the device. Labels have the form "asperity::package::name".
template <class T>
Kokkos::View<T*, MemorySpace> toDevice(std::vector<T> const& values, std::string const& label)
{
  const Kokkos::View<T*, MemorySpace> view(label, values.size());
  auto const host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < values.size(); ++i) {
    host(i) = values[i];
  }
  Kokkos::deep_copy(view, host);
  return view;
}

// A copy that the host can read.
template <class View>
auto toHost(View const& view)
{
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}
} // namespace asperity
