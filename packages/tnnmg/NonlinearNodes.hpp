#pragma once

#include "base/Types.hpp"
#include "tnnmg/Colouring.hpp"
#include "tnnmg/LinearCorrection.hpp"

#include <vector>

namespace asperity::tnnmg
{
using NodeView = Kokkos::View<double*, MemorySpace>;
using ConstNodeView = Kokkos::View<const double*, MemorySpace>;
using BlockView = Kokkos::View<double**, Kokkos::LayoutRight, MemorySpace>;
using ConstBlockView = Kokkos::View<const double**, Kokkos::LayoutRight, MemorySpace>;
using HessianView = Kokkos::View<double***, Kokkos::LayoutRight, MemorySpace>;
using FlagView = Kokkos::View<int*, MemorySpace>;
using ComponentFlagView = Kokkos::View<const int**, Kokkos::LayoutRight, MemorySpace>;
using IndexView = Kokkos::View<const int*, MemorySpace>;

// The nodes that carry a nonlinearity on this rank: which rows of Z they have, which of these are
// held, and in which groups a sweep visits them. A node may be held in some components and free in
// others: its velocity in the held ones is zero then, their rows of Z are diagonal, and the
// nonlinearity is isotropic, so that a force along the free ones moves the node along them.
struct NonlinearNodes
{
  NonlinearDofView dofs;   // (num_nodes, T)
  ComponentFlagView fixed; // (num_nodes, T): 1 where the velocity is prescribed
  // Nodes that are free in some component, by colour; as many colours on every rank.
  std::vector<IndexView> colours;

  int numNodes() const { return static_cast<int>(dofs.extent(0)); }
  int blockSize() const { return static_cast<int>(dofs.extent(1)); }
};

// Colours the nodes across ranks by the graph of Z. dofs(num_nodes, T) and fixed(num_nodes, T) on
// the host.
NonlinearNodes nonlinearNodes(CrsMatrix const& Z, std::vector<std::vector<int>> const& dofs,
                              int block_size, std::vector<std::vector<int>> const& fixed);

// Every such node a colour of its own: for a matrix that couples all of them, on one rank.
NonlinearNodes coupledNodes(int num_nodes, int block_size,
                            std::vector<std::vector<int>> const& fixed);
} // namespace asperity::tnnmg
