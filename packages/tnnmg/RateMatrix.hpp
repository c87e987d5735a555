#pragma once

#include "tnnmg/NodalProblem.hpp"
#include "tnnmg/NonlinearNodes.hpp"

#include <Tpetra_Vector.hpp>

namespace asperity::tnnmg
{
// Z as TNNMG uses it, with the nonlinear nodes among its rows: SparseRateMatrix on any number of
// ranks, DenseRateMatrix on one. All ranks call each function together.
class RateMatrix
{
public:
  virtual ~RateMatrix() = default;

  NonlinearNodes const& nodes() const { return nodes_; }
  // Where b, r and v live; and where v lives with the ghosts that rows of Z need, owned rows first.
  RCP<const Map> const& rows() const { return rows_; }
  RCP<const Map> const& columns() const { return columns_; }
  Vector const& diagonal() const { return *diagonal_; }
  // The curvature of the model I^m (Pipping 2014, ch. 4), (num_nodes): the largest eigenvalue of
  // each node's diagonal block of Z in its free components, or for T = 3 Gershgorin's bound of it.
  ConstNodeView const& curvature() const { return curvature_; }

  // y = Z x
  virtual void apply(Vector const& x, Vector& y) const = 0;
  // y_i = sum of |Z_ij x_j| over j: of the terms of Z x, of which a sum in any order has rounding.
  virtual void sumMagnitudes(Vector const& x, Vector& y) const = 0;

  // One sweep of nonlinear block Gauss-Seidel over the nonlinear nodes: the model is minimised node
  // by node, over all ranks, so that J does not rise. Updates v_columns (v on columns()) and
  // blocks(num_nodes, T), the values of v at the nonlinear nodes. r is b - Z v before the first
  // sweep. A matrix either updates r in each sweep, as the dense one does, or leaves it alone and
  // takes what it needs from b; finishSweeps() makes r current in both cases. residual(num_nodes,
  // T) is work space. Returns the number of nodes whose minimisation failed on this rank.
  virtual int sweep(NodalProblem const& problem, Vector const& b, Vector& v_columns, Vector& r,
                    BlockView const& blocks, BlockView const& residual) const = 0;
  // r = b - Z v after sweeps, in which v changed by d(num_nodes, T) at the nonlinear nodes. Does
  // nothing if the sweeps have kept r current.
  virtual void finishSweeps(ConstBlockView const& d, Vector const& b, Vector const& v,
                            Vector& r) const = 0;

  // r = b - Z v
  void residual(Vector const& b, Vector const& v, Vector& r) const;

protected:
  // blocks(num_nodes, T, T): the diagonal blocks of Z at the nodes.
  RateMatrix(NonlinearNodes nodes, RCP<const Map> rows, RCP<const Map> columns,
             RCP<const Vector> diagonal, HessianView const& blocks);

private:
  NonlinearNodes nodes_;
  RCP<const Map> rows_, columns_;
  RCP<const Vector> diagonal_;
  ConstNodeView curvature_;
};

// Copy v(dofs) to blocks, and back at the nodes `which`; v may live on rows() or on columns().
void gather(NodeDofView const& dofs, Vector const& v, BlockView const& blocks);
void scatter(NonlinearNodes const& nodes, IndexView const& which, ConstBlockView const& blocks,
             Vector& v);
} // namespace asperity::tnnmg
