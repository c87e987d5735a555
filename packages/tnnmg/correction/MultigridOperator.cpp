#include "tnnmg/correction/MultigridOperator.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <utility>

namespace asperity::tnnmg::detail
{
MultigridOperator::MultigridOperator(RCP<const CrsMatrix> Z,
                                     std::shared_ptr<const MultigridNodes> nodes)
    : Z_(std::move(Z))
    , nodes_(std::move(nodes))
{
}

RCP<const Map> MultigridOperator::getDomainMap() const { return Z_->getDomainMap(); }

RCP<const Map> MultigridOperator::getRangeMap() const { return Z_->getRangeMap(); }

void MultigridOperator::apply(MultiVector const& x, MultiVector& y, Teuchos::ETransp, double alpha,
                              double beta) const
{
  Z_->apply(x, y, Teuchos::NO_TRANS, alpha, beta);
  {
    const auto in = x.getLocalViewDevice(Tpetra::Access::ReadOnly);
    const auto out = y.getLocalViewDevice(Tpetra::Access::ReadWrite);
    const auto dofs = nodes_->view.dofs;
    const auto hessian = nodes_->hessian;
    Kokkos::parallel_for(
      "asperity::tnnmg::applyHessian", RangePolicy(0, nodes_->size()), KOKKOS_LAMBDA(int node) {
        for (int s = 0; s < dofs.extent_int(1); ++s) {
          for (int t = 0; t < dofs.extent_int(1); ++t) {
            out(dofs(node, s), 0) += alpha * hessian(node, s, t) * in(dofs(node, t), 0);
          }
        }
      });
  }
  nodes_->project(y);
}
} // namespace asperity::tnnmg::detail
