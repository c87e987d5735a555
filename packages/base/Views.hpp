#pragma once

#include "base/Types.hpp"
#include "portability/Views.hpp"

#include <string>
#include <vector>

// The dofs at nodes, and the ways of views to and from the host.
namespace asperity
{
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
