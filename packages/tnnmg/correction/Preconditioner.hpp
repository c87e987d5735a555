#pragma once

#include "tnnmg/correction/CoarseHessians.hpp"
#include "tnnmg/correction/MultigridOperator.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <cstddef>
#include <memory>
#include <utility>

namespace asperity::tnnmg::detail
{
// A symmetric approximation of (Z + H)^-1 on the dofs that are neither removed nor held, by one
// cycle of multigrid: the fine level follows the blocks of the nodes in every solve, coarse levels
// are brought up to date on demand. Only alpha = 1 and beta = 0 are allowed in apply, and r = P r.
class Preconditioner : public Operator
{
public:
  Preconditioner(RCP<const CrsMatrix> Z, std::shared_ptr<const MultigridNodes> nodes)
      : Z_(std::move(Z))
      , nodes_(std::move(nodes))
      , coarse_(nodes_)
  {
  }

  // Adapts the fine level; has to be called after the blocks of the nodes have changed. Throws
  // SolveError if a matrix is not positive definite.
  virtual void setup() = 0;

  // The share of the nonlinear nodes, over all ranks, whose Hessian on the coarse levels differs
  // from the current one by more than a factor. Smooth errors are then corrected by too much or too
  // little, the more so the finer the mesh is. Collective.
  double outdatedShare() const { return coarse_.outdatedShare(*Z_->getComm()); }

  // Brings the current Hessians into the coarse levels.
  virtual void rebuild() = 0;
  // The next set-up takes the Hessians out of the coarse levels, unless rebuild() comes first.
  void forgetHessians() { coarse_.forget(); }

  int numCycles() const { return num_cycles_; } // so far
  virtual std::size_t bytes() const = 0;        // of this rank, without what corrections share

  RCP<const Map> getDomainMap() const override { return Z_->getDomainMap(); }
  RCP<const Map> getRangeMap() const override { return Z_->getRangeMap(); }

protected:
  RCP<const CrsMatrix> Z_;
  std::shared_ptr<const MultigridNodes> nodes_;
  CoarseHessians coarse_;
  mutable int num_cycles_ = 0;
};
} // namespace asperity::tnnmg::detail
