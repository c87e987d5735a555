#include "dynamics/rate/CondensedFunctionals.hpp"

#include "portability/Renamed.hpp"

#include <Tpetra_Map.hpp>

namespace asperity::dynamics
{
namespace
{
Eigen::VectorXd toEigen(Vector const& x)
{
  auto const view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  return Eigen::Map<const Eigen::VectorXd>(view.data(), static_cast<int>(view.extent(0)));
}
} // namespace

CondensedFunctionals::CondensedFunctionals(tnnmg::SchurComplement const& schur,
                                           RCP<const CrsMatrix> const& N)
    : N_(N)
    , at_rest_(N->getDomainMap())
    , constant_(N->getRangeMap())
    , zero_(schur.map())
    , matrix_(numLocalRows(*N), numLocalElements(*schur.map()))
{
  auto const local = N->getLocalMatrixHost();
  for (int row = 0; row < local.numRows(); ++row) {
    at_rest_.putScalar(0);
    {
      auto const values = at_rest_.getLocalViewHost(Tpetra::Access::ReadWrite);
      for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
        values(local.graph.entries(k), 0) = local.values(k);
      }
    }
    matrix_.row(row) = toEigen(schur.condense(at_rest_).kept()).transpose();
  }
}

void CondensedFunctionals::begin(tnnmg::CondensedRightSide const& b)
{
  b.expand(zero_, at_rest_);
  N_->apply(at_rest_, constant_);
}

void CondensedFunctionals::apply(Vector const& w_kept, NodeView const& r) const
{
  auto const host = Kokkos::create_mirror_view(r);
  Eigen::Map<Eigen::VectorXd>(host.data(), host.extent_int(0)) =
    toEigen(constant_) + matrix_ * toEigen(w_kept);
  Kokkos::deep_copy(r, host);
}
} // namespace asperity::dynamics
