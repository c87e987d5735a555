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
// of block Gauss-Seidel on the nonlinear nodes. The V-cycle works with a matrix that may know other
// Hessians, or none, and is scaled at each node by S = L^-T L0^T, where L L^T and L0 L0^T are the
// node's blocks of Z + H and of that matrix.
class MultigridPreconditioner : public Operator
{
public:
  MultigridPreconditioner(RCP<const MultigridOperator> A, RCP<const CrsMatrix> Z,
                          RCP<const MultiVector> near_null_space,
                          std::shared_ptr<const MultigridNodes> nodes,
                          Teuchos::ParameterList const& muelu);

  // After the nodes have got new blocks: adapts smoother and scaling, and keeps the hierarchy.
  void setup();

  // The share of nonlinear nodes, of all ranks, that the hierarchy has and the current blocks had
  // better left out (removed or stiff), or the other way round, or that it has with a Hessian that
  // is now wrong by an order of magnitude: its coarse levels would correct smooth errors by too
  // much or too little, the more so the finer the mesh.
  double outdated() const;

  // Hierarchy from the current blocks; prolongators stay.
  void rebuild();
  // Back to a hierarchy that knows no Hessians. It is made by the next set-up, unless a rebuild
  // comes first, and in the same way as a rebuild: on several ranks the constructor's has other
  // last digits.
  void forget();
  // Whether the next set-up begins with a hierarchy from Z.
  bool isDue() const { return is_due_; }

  RCP<const Map> getDomainMap() const override { return A_->getDomainMap(); }
  RCP<const Map> getRangeMap() const override { return A_->getRangeMap(); }

  // z = B r with r = P r; alpha = 1 and beta = 0 alone.
  void apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp mode = Teuchos::NO_TRANS,
             double alpha = 1, double beta = 0) const override;

  // V-cycles so far.
  int numCycles() const { return num_cycles_; }

private:
  RCP<const CrsMatrix> withoutHessians();
  FlagView unfit() const;
  void scale(MultiVector& x, bool transposed) const;

  RCP<const MultigridOperator> A_;
  RCP<const CrsMatrix> Z_;
  std::shared_ptr<const MultigridNodes> nodes_;
  MultigridSmoother smoother_;
  RCP<CrsMatrix> coupled_; // what the hierarchy knows for Z without Hessians, if that is not Z
  MultigridHierarchy hierarchy_;
  std::optional<MultigridTruncatedMatrix> truncated_; // what the hierarchy was rebuilt from
  bool is_of_Z_ = false;                              // by a rebuild
  bool is_due_ = false;

  FlagView excluded_;       // nodes that the hierarchy's matrix has without their couplings
  NodeBlockView reference_; // the others' blocks there
  NodeBlockView scaling_;   // S, zero where excluded or removed
  RCP<MultiVector> residual_, cycle_;
  mutable int num_cycles_ = 0;
};
} // namespace asperity::tnnmg::detail
