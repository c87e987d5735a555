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
// A symmetric approximation of (Z + H)^-1 on the dofs that are left: a V-cycle between two sweeps
// of block Gauss-Seidel on the nonlinear nodes. The V-cycle works with a matrix that may have other
// Hessians, or none, and is scaled at each node by S = L^-T L0^T, where L L^T and L0 L0^T are the
// node's blocks of Z + H and of that matrix.
class MultigridPreconditioner : public Operator
{
public:
  MultigridPreconditioner(RCP<const MultigridOperator> A, RCP<const CrsMatrix> Z,
                          RCP<const MultiVector> near_null_space,
                          std::shared_ptr<const MultigridNodes> nodes,
                          Teuchos::ParameterList const& muelu);

  // To be called after the nodes have got new blocks: adapts smoother and scaling, and keeps the
  // hierarchy unless a rebuild from Z is pending.
  void setup();

  // The share of all ranks' nonlinear nodes that the hierarchy treats wrongly: it includes a node
  // that is now removed or stiff, excludes one that is neither, or has a Hessian that differs from
  // the current one by an order of magnitude. Its coarse levels then correct smooth errors by too
  // much or too little; this effect grows as the mesh is refined.
  double outdatedShare() const;

  // Builds the hierarchy from the current blocks and keeps the prolongators.
  void rebuild();
  // Returns to a hierarchy of Z without Hessians. The next set-up makes it, unless a rebuild comes
  // first. It is made in the same way as by a rebuild, because on several ranks the hierarchy of
  // the constructor differs in the last digits.
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
  FlagView nodesToExclude() const;
  void scale(MultiVector& x, bool transposed) const;

  RCP<const MultigridOperator> A_;
  RCP<const CrsMatrix> Z_;
  std::shared_ptr<const MultigridNodes> nodes_;
  MultigridSmoother smoother_;
  RCP<CrsMatrix> coupled_; // the hierarchy's matrix without Hessians, if it is not Z
  MultigridHierarchy hierarchy_;
  std::optional<MultigridTruncatedMatrix> truncated_; // what the hierarchy was rebuilt from
  bool hierarchy_is_of_Z_ = false;                    // after a rebuild
  bool rebuild_from_Z_is_pending_ = false;

  FlagView excluded_;       // nodes whose couplings the hierarchy's matrix leaves out
  NodeBlockView reference_; // blocks of the other nodes in that matrix
  NodeBlockView scaling_;   // S, zero where excluded or removed
  RCP<MultiVector> residual_, cycle_;
  mutable int num_cycles_ = 0;
};
} // namespace asperity::tnnmg::detail
