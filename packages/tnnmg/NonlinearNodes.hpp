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
  // Whether each node is coupled with each, as coupledNodes() says; then one colour has all of
  // them, in the order in which a sweep visits them.
  bool are_coupled = false;

  int numNodes() const { return static_cast<int>(dofs.extent(0)); }
  int blockSize() const { return static_cast<int>(dofs.extent(1)); }
};

// The linear part of a problem of coupled nodes, in the order of coupledNodes().
struct CoupledSystem
{
  ConstBlockView Z; // (num_nodes T, num_nodes T), symmetric
  BlockView r;      // (num_nodes, T): b - Z v of the present v
  ConstFlagView held;
  ConstNodeView curvature;
};

// The nodes of a full matrix, on one rank: the rows of every node's block_size components follow
// those of the node before. held(num_nodes * block_size).
NonlinearNodes coupledNodes(int num_nodes, int block_size, std::vector<int> const& held);
} // namespace asperity::tnnmg
