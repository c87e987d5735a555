#pragma once

#include "multigrid/FloatConjugateGradients.hpp"
#include "tnnmg/correction/Preconditioner.hpp"
#include "tnnmg/hierarchy/MultigridHierarchy.hpp"

#include <memory>
#include <string>
#include <vector>

namespace asperity::tnnmg::detail
{
// Asperity's own V-cycle, that of package multigrid, in single precision.
class OwnPreconditioner final : public Preconditioner
{
public:
  // Z is the sum of the hierarchy's terms times weights. smoother: of multigrid::SmootherRegistry.
  OwnPreconditioner(MultigridHierarchy const& hierarchy, std::vector<double> const& weights,
                    RCP<const CrsMatrix> Z, std::shared_ptr<const MultigridNodes> nodes,
                    std::string const& smoother = multigrid::Cycle::usual_smoother);

  void setup() override;
  void rebuild() override;
  std::size_t bytes() const override { return cycle_.bytes(); }

  void apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp mode = Teuchos::NO_TRANS,
             double alpha = 1, double beta = 0) const override;

  // (Z + H) c = r by conjugate gradients in single precision with this preconditioner, for
  // relative tolerances from FloatConjugateGradients::smallest_tolerance.
  multigrid::IterationResult solveInSinglePrecision(Vector const& r, double relative_tolerance,
                                                    int max_iterations, Vector& c) const;

private:
  mutable multigrid::Cycle cycle_;
  mutable multigrid::FloatConjugateGradients gradients_;
  multigrid::NodeVector r_; // what apply() gives to the cycle
};
} // namespace asperity::tnnmg::detail
