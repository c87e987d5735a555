#pragma once

#include "base/Types.hpp"
#include "portability/Views.hpp"

namespace asperity
{
// (num_nodes, T): the local dofs of T components at each node.
using NodeDofView = Kokkos::View<const LocalOrdinal**, Kokkos::LayoutRight, MemorySpace>;
} // namespace asperity
