#pragma once

#include "tnnmg/LinearCorrection.hpp"
#include "tnnmg/NonlinearNodes.hpp"

namespace asperity::tnnmg::detail
{
// A view of the nonlinear nodes of this rank, and their blocks in the current solve, shared by the
// operator, the smoother and the preconditioner of one correction. All blocks are
// (num_nodes, T, T).
struct MultigridNodes
{
  NonlinearNodes view;
  IndexView held_rows;
  HessianView diagonal; // of Z at the node
  HessianView hessian;  // of this solve; zero where the node is removed
  FlagView removed;     // (num_nodes) 1 where the node is truncated in this solve

  int size() const { return view.numNodes(); }
  int tangents() const { return view.blockSize(); }

  // Takes the Hessians and the truncated nodes of the next solve.
  void set(NonlinearBlocks const& blocks);

  // Sets x to zero at removed and held dofs.
  void project(MultiVector& x) const;
};

// Takes the rows and blocks of Z at the nodes; no node is removed, and the Hessians are zero.
MultigridNodes makeNodes(CrsMatrix const& Z, NonlinearNodes const& view,
                         IndexView const& held_rows);
} // namespace asperity::tnnmg::detail
