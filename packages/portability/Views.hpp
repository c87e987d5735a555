#pragma once

#include "portability/Spaces.hpp"

#include <Kokkos_Core.hpp>

#include <string>
#include <vector>

// Views of what is known at the nodes of a fault, each indexed by the node's local number, and the
// copies of views between device and host.
namespace asperity
{
using NodeView = Kokkos::View<double*, MemorySpace>; // (num_nodes)
using ConstNodeView = Kokkos::View<const double*, MemorySpace>;
using FlagView = Kokkos::View<int*, MemorySpace>; // (num_nodes), 0 or 1
// Any number of local rows, columns or nodes.
using IndexView = Kokkos::View<const int*, MemorySpace>;
// One flag for each local row or node: 0 or 1.
using ConstFlagView = Kokkos::View<const int*, MemorySpace>;

// Tangential vectors: T = 1 component in two dimensions and antiplane, 2 in three.
using BlockView = Kokkos::View<double**, Kokkos::LayoutRight, MemorySpace>; // (num_nodes, T)
using ConstBlockView = Kokkos::View<const double**, Kokkos::LayoutRight, MemorySpace>;
using HessianView = Kokkos::View<double***, Kokkos::LayoutRight, MemorySpace>; // (num_nodes, T, T)

// A copy where kernels run. Labels have the form "asperity::package::name".
template <class T>
Kokkos::View<T*, MemorySpace> toDevice(std::vector<T> const& values, std::string const& label)
{
  const Kokkos::View<const T*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> host(values.data(),
                                                                                values.size());
  const Kokkos::View<T*, MemorySpace> view(label, values.size());
  Kokkos::deep_copy(view, host);
  return view;
}

// A copy that the host can read; where kernels run on the host, the view itself.
template <class View>
auto toHost(View const& view)
{
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), view);
}

// The numbers of a view (n).
template <class View>
auto toVector(View const& view)
{
  static_assert(View::rank == 1, "A vector holds the numbers of one dimension");
  auto const host = toHost(view);
  return std::vector<typename View::non_const_value_type>(host.data(),
                                                          host.data() + host.extent(0));
}
} // namespace asperity
