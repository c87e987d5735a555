#pragma once

#include "tnnmg/LinearCorrection.hpp"
#include "tnnmg/NonlinearNodes.hpp"

namespace asperity::tnnmg::detail
{
using NodeBlockView = Kokkos::View<double***, Kokkos::LayoutRight, MemorySpace>;

// A view of the nonlinear nodes of this rank, and their blocks in the current solve. Shared by
// operator, smoother and preconditioner of one correction; all blocks are (num_nodes, T, T).
struct MultigridNodes
{
  NonlinearNodes view;
  IndexView held_rows;
  NodeBlockView diagonal; // of Z at the node
  NodeBlockView hessian;  // of this solve; zero where the node is removed
  FlagView removed;       // of this solve: truncated

  int size() const { return static_cast<int>(view.dofs.extent(0)); }
  int tangents() const { return static_cast<int>(view.dofs.extent(1)); }

  // Takes the Hessians and the truncated nodes of the next solve.
  void set(NonlinearBlocks const& blocks);

  // x = 0 at removed and held dofs.
  void project(MultiVector& x) const;
};

// Takes the rows and blocks of Z at the nodes; no node is removed, and the Hessians are zero.
MultigridNodes makeNodes(CrsMatrix const& Z, NonlinearNodes const& view,
                         IndexView const& held_rows);
} // namespace asperity::tnnmg::detail
