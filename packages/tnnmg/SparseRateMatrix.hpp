#pragma once

#include "tnnmg/FaultColumns.hpp"
#include "tnnmg/RateMatrix.hpp"

#include <Tpetra_CrsMatrix.hpp>

namespace asperity::tnnmg
{
// A sparse Z on any number of ranks. A sweep visits the nodes a colour at a time.
class SparseRateMatrix final : public RateMatrix
{
public:
  // Z is fill-complete and symmetric; its column map starts with the owned rows, in the order of
  // the domain map. Collective.
  SparseRateMatrix(RCP<const CrsMatrix> Z, NonlinearNodes const& nodes);

  void apply(Vector const& x, Vector& y) const override;
  void sumMagnitudes(Vector const& x, Vector& y) const override;
  int sweep(NodalProblem const& problem, Vector const& b, Vector& v_columns, Vector& r,
            BlockView const& blocks, BlockView const& residual) const override;
  void finishSweeps(ConstBlockView const& d, Vector const& b, Vector const& v,
                    Vector& r) const override;

private:
  void copyWithGhosts(Vector const& x) const; // to work_

  RCP<const CrsMatrix> Z_;
  FaultColumns exchange_;
  RCP<Vector> work_;           // on columns()
  bool has_few_nodes_ = false; // the nonlinear ones, with few of the dofs of all ranks
};

// (num_nodes, T, T): the blocks of Z at the nodes. Z's column map starts with the owned rows.
HessianView diagonalBlocks(CrsMatrix const& Z, NonlinearNodes const& nodes);
} // namespace asperity::tnnmg
