#pragma once

#include "tnnmg/LinearCorrection.hpp"

namespace asperity::tnnmg::detail
{
using NodeBlockView = Kokkos::View<double***, Kokkos::LayoutRight, MemorySpace>;
using FlagView = Kokkos::View<int*, MemorySpace>;

// The nonlinear nodes of this rank and their blocks in the current solve. Shared by operator,
// smoother and preconditioner of one correction; all blocks are (num_nodes, T, T).
struct MultigridNodes
{
  NonlinearDofView dofs; // (num_nodes, T)
  RowView constrained;
  NodeBlockView diagonal; // of Z at the node
  NodeBlockView hessian;  // of this solve; zero where the node is removed
  FlagView removed;       // of this solve: truncated

  int size() const { return static_cast<int>(dofs.extent(0)); }
  int tangents() const { return static_cast<int>(dofs.extent(1)); }

  // Takes the Hessians and the truncated nodes of the next solve.
  void set(NonlinearBlocks const& blocks);

  // x = 0 at removed and constrained dofs.
  void project(MultiVector& x) const;
};

// Takes the rows and blocks of Z at the nodes; no node is removed, and the Hessians are zero.
MultigridNodes makeNodes(CrsMatrix const& Z, NonlinearDofView const& dofs,
                         RowView const& constrained);
} // namespace asperity::tnnmg::detail
