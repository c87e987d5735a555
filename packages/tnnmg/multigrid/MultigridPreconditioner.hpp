#pragma once

#include "multigrid/FloatConjugateGradients.hpp"
#include "tnnmg/hierarchy/MultigridHierarchy.hpp"
#include "tnnmg/multigrid/CoarseHessians.hpp"
#include "tnnmg/multigrid/Preconditioner.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <memory>
#include <vector>

namespace asperity::tnnmg::detail
{
// The V-cycle of package multigrid, in single precision.
class MultigridPreconditioner final : public Preconditioner
{
public:
  // Z is the sum of the hierarchy's terms times weights.
  MultigridPreconditioner(MultigridHierarchy const& hierarchy, std::vector<double> const& weights,
                          RCP<const CrsMatrix> Z, std::shared_ptr<const MultigridNodes> nodes);

  void setup() override;
  double outdatedShare() const override;
  void rebuild() override;
  void forgetHessians() override { coarse_.forget(); }
  int numCycles() const override { return num_cycles_; }
  std::size_t bytes() const override { return cycle_.bytes(); }

  RCP<const Map> getDomainMap() const override { return Z_->getDomainMap(); }
  RCP<const Map> getRangeMap() const override { return Z_->getRangeMap(); }
  void apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp mode = Teuchos::NO_TRANS,
             double alpha = 1, double beta = 0) const override;

  // (Z + H) c = r by conjugate gradients in single precision with this preconditioner, for
  // relative tolerances from FloatConjugateGradients::certain.
  multigrid::IterationResult solveLoosely(Vector const& r, double relative_tolerance,
                                          int max_iterations, Vector& c) const;

private:
  RCP<const CrsMatrix> Z_;
  std::shared_ptr<const MultigridNodes> nodes_;
  mutable multigrid::Cycle cycle_;
  mutable multigrid::FloatConjugateGradients gradients_;
  CoarseHessians coarse_;
  multigrid::NodeVector r_; // what apply() gives to the cycle
  mutable int num_cycles_ = 0;
};
} // namespace asperity::tnnmg::detail
