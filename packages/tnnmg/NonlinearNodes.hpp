#pragma once

#include "base/Views.hpp"

#include <vector>

namespace asperity::tnnmg
{
using NodeView = Kokkos::View<double*, MemorySpace>;
using ConstNodeView = Kokkos::View<const double*, MemorySpace>;
using BlockView = Kokkos::View<double**, Kokkos::LayoutRight, MemorySpace>;
using ConstBlockView = Kokkos::View<const double**, Kokkos::LayoutRight, MemorySpace>;
using HessianView = Kokkos::View<double***, Kokkos::LayoutRight, MemorySpace>;
using FlagView = Kokkos::View<int*, MemorySpace>;

// Views of the nodes that carry a nonlinearity on this rank: which rows of Z they have, which rows
// are held, and in which groups a sweep visits them. A node may be held in some components and free
// in others. Then its velocity is zero in the held components, their rows of Z are diagonal, and
// the nonlinearity is isotropic, so that a force along the free components moves the node along
// these.
struct NonlinearNodes
{
  NodeDofView dofs; // (num_nodes, T), local rows of Z
  // (at least num local rows): 1 where the velocity is prescribed.
  ConstFlagView held;
  // Nodes that are free in some component, by colour. All ranks have the same number of colours.
  std::vector<IndexView> colours;

  int numNodes() const { return static_cast<int>(dofs.extent(0)); }
  int blockSize() const { return static_cast<int>(dofs.extent(1)); }
};

// The linear part of a problem in which each node is coupled with each. The rows and columns of Z
// are the T components of node 0, then those of node 1, and so on.
struct CoupledSystem
{
  ConstBlockView Z; // (num_nodes T, num_nodes T), symmetric
  BlockView r;      // (num_nodes, T): b - Z v of the present v
  ConstFlagView held;
  ConstNodeView curvature;
};
} // namespace asperity::tnnmg
