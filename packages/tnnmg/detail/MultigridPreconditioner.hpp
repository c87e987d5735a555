#pragma once

#include "tnnmg/detail/MultigridHierarchy.hpp"
#include "tnnmg/detail/MultigridOperator.hpp"
#include "tnnmg/detail/MultigridSmoother.hpp"
#include "tnnmg/detail/MultigridTruncatedMatrix.hpp"

#include <Teuchos_ParameterList.hpp>

#include <memory>
#include <optional>

namespace asperity::tnnmg::detail
{
// A symmetric approximation of (Z + H)^-1 on the dofs that are neither removed nor held: a V-cycle
// between two sweeps of block Gauss-Seidel on the nonlinear nodes. The matrix of the V-cycle may
// have other Hessians than H, or none. The V-cycle is therefore scaled at each node by
// S = L^-T L0^T, where L L^T and L0 L0^T are the node's blocks of Z + H and of that matrix.
class MultigridPreconditioner : public Operator
{
public:
  MultigridPreconditioner(RCP<const MultigridOperator> A, RCP<const CrsMatrix> Z,
                          RCP<const MultiVector> near_null_space,
                          std::shared_ptr<const MultigridNodes> nodes,
                          Teuchos::ParameterList const& muelu);

  // Adapts the smoother and the scaling; has to be called after the blocks of the nodes have
  // changed. Keeps the hierarchy unless a rebuild from Z is pending.
  void setup();

  // The share of the nonlinear nodes, over all ranks, at which the hierarchy is out of date: it
  // includes the node although the node is now removed or stiff, excludes it although it is
  // neither, or has a Hessian that differs from the current one by an order of magnitude. The
  // coarse levels then correct smooth errors by too much or too little, the more so the finer the
  // mesh is. Collective.
  double outdatedShare() const;

  // Builds the hierarchy from the current blocks and keeps the prolongators.
  void rebuild();
  // Goes back to a hierarchy of Z without Hessians: the next set-up rebuilds it from Z, unless
  // rebuild() comes first. Even the hierarchy of the constructor is rebuilt, because on several
  // ranks it differs from a rebuilt one in the last digits.
  void returnToHierarchyOfZ();
  // Whether the next set-up will make the hierarchy from Z.
  bool willRebuildFromZ() const { return rebuild_from_Z_is_pending_; }

  RCP<const Map> getDomainMap() const override { return A_->getDomainMap(); }
  RCP<const Map> getRangeMap() const override { return A_->getRangeMap(); }

  // Computes z = B r for r = P r; only alpha = 1 and beta = 0 are allowed.
  void apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp mode = Teuchos::NO_TRANS,
             double alpha = 1, double beta = 0) const override;

  // The number of V-cycles so far.
  int numCycles() const { return num_cycles_; }

private:
  RCP<const CrsMatrix> withoutHessians();
  void scale(MultiVector& x, bool transposed) const;

  RCP<const MultigridOperator> A_;
  RCP<const CrsMatrix> Z_;
  std::shared_ptr<const MultigridNodes> nodes_;
  MultigridSmoother smoother_;
  RCP<CrsMatrix> coupled_; // the hierarchy's matrix without Hessians, if it is not Z
  MultigridHierarchy hierarchy_;
  std::optional<MultigridTruncatedMatrix> truncated_; // the matrix of the last rebuild()
  bool hierarchy_is_of_Z_ = false;                    // it was rebuilt from Z
  bool rebuild_from_Z_is_pending_ = false;

  FlagView excluded_;       // nodes whose couplings the hierarchy's matrix leaves out
  NodeBlockView reference_; // blocks of the other nodes in that matrix
  NodeBlockView scaling_;   // S, zero where excluded or removed
  RCP<MultiVector> residual_, cycle_;
  mutable int num_cycles_ = 0;
};
} // namespace asperity::tnnmg::detail
