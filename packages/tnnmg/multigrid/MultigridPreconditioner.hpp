#pragma once

#include "multigrid/FloatConjugateGradients.hpp"
#include "tnnmg/hierarchy/MultigridHierarchy.hpp"
#include "tnnmg/multigrid/MultigridOperator.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <memory>
#include <vector>

namespace asperity::tnnmg::detail
{
// A symmetric approximation of (Z + H)^-1 on the dofs that are neither removed nor held: a V-cycle
// whose fine level has the Hessians and removed nodes of the solve, while those of the coarse
// levels are brought up to date on demand, with a limit for those much larger than Z.
class MultigridPreconditioner : public Operator
{
public:
  // Z is the sum of the hierarchy's terms times weights.
  MultigridPreconditioner(MultigridHierarchy const& hierarchy, std::vector<double> const& weights,
                          RCP<const CrsMatrix> Z, std::shared_ptr<const MultigridNodes> nodes);

  // Adapts the fine level; has to be called after the blocks of the nodes have changed. Throws
  // SolveError if a matrix is not positive definite.
  void setup();

  // The share of the nonlinear nodes, over all ranks, whose Hessian on the coarse levels differs
  // from the current one by more than a factor. Smooth errors are then corrected by too much or too
  // little, the more so the finer the mesh is. Collective.
  double outdatedShare() const;

  // Brings the current Hessians into the coarse levels.
  void rebuild();
  // The next set-up takes the Hessians out of the coarse levels, unless rebuild() comes first.
  void forgetHessians();

  RCP<const Map> getDomainMap() const override { return Z_->getDomainMap(); }
  RCP<const Map> getRangeMap() const override { return Z_->getRangeMap(); }

  // Computes z = B r for r = P r; only alpha = 1 and beta = 0 are allowed.
  void apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp mode = Teuchos::NO_TRANS,
             double alpha = 1, double beta = 0) const override;

  // (Z + H) c = r by conjugate gradients in single precision with this preconditioner, for
  // relative tolerances from FloatConjugateGradients::certain.
  multigrid::IterationResult solveLoosely(Vector const& r, double relative_tolerance,
                                          int max_iterations, Vector& c) const;

  // The number of V-cycles so far.
  int numCycles() const { return num_cycles_; }
  std::size_t bytes() const { return cycle_.bytes(); } // of this rank, without the hierarchy

private:
  RCP<const CrsMatrix> Z_;
  std::shared_ptr<const MultigridNodes> nodes_;
  mutable multigrid::Cycle cycle_;
  mutable multigrid::FloatConjugateGradients gradients_;
  bool has_coarse_hessians_ = false;
  bool forgets_ = false; // the coarse Hessians, at the next set-up

  HessianView coarse_;      // the Hessians on the coarse levels
  multigrid::NodeVector r_; // what apply() gives to the cycle
  mutable int num_cycles_ = 0;
};
} // namespace asperity::tnnmg::detail
