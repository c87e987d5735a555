#pragma once

#include "tnnmg/correction/MultigridNodes.hpp"

#include <Tpetra_Operator.hpp>

#include <memory>

namespace asperity::tnnmg::detail
{
using Operator = Tpetra::Operator<double, LocalOrdinal, GlobalOrdinal>;

// Z + H without the removed and the constrained dofs: y = P (Z + H) x with x = P x, where P sets
// these dofs to zero. Every vector in a correction satisfies x = P x, so P has to be applied on the
// left only.
class MultigridOperator : public Operator
{
public:
  MultigridOperator(RCP<const CrsMatrix> Z, std::shared_ptr<const MultigridNodes> nodes);

  RCP<const Map> getDomainMap() const override;
  RCP<const Map> getRangeMap() const override;

  // Works on one vector at a time. The operator is symmetric, so mode has no effect.
  void apply(MultiVector const& x, MultiVector& y, Teuchos::ETransp mode = Teuchos::NO_TRANS,
             double alpha = 1, double beta = 0) const override;

private:
  RCP<const CrsMatrix> Z_;
  std::shared_ptr<const MultigridNodes> nodes_;
};
} // namespace asperity::tnnmg::detail
