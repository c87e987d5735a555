#include "tnnmg/correction/OwnPreconditioner.hpp"

#include "base/Errors.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <string>
#include <utility>
#include <vector>

namespace asperity::tnnmg::detail
{
namespace
{
// 1 at the given rows, 0 at others.
std::vector<char> flagsOf(IndexView const& rows, std::size_t num_rows)
{
  std::vector<char> flags(num_rows, 0);
  const auto on_host = toHost(rows);
  for (int k = 0; k < on_host.extent_int(0); ++k) {
    flags[on_host(k)] = 1;
  }
  return flags;
}

// The only column of a vector.
template <class View>
auto numbersOf(View const& view)
{
  return Kokkos::subview(view, Kokkos::ALL(), 0);
}
} // namespace

OwnPreconditioner::OwnPreconditioner(MultigridHierarchy const& hierarchy,
                                     std::vector<double> const& weights, RCP<const CrsMatrix> Z,
                                     std::shared_ptr<const MultigridNodes> nodes,
                                     std::string const& smoother)
    : Preconditioner(std::move(Z), std::move(nodes))
    , cycle_(hierarchy.shared(), weights, hierarchy.finestBlocks(*Z_),
             flagsOf(nodes_->held_rows, numLocalRows(*Z_)), nodes_->view.dofs, smoother)
    , gradients_(cycle_, sumOver(Z_->getComm()))
    , r_(multigrid::makeNumbers(cycle_.rows()))
{
  setup();
}

void OwnPreconditioner::setup()
{
  if (coarse_.forgotten()) {
    cycle_.setCoarseBlocks(coarse_.values());
  }
  if (!cycle_.setup(nodes_->hessian, nodes_->removed)) {
    throw SolveError(
      "Multigrid: the coarsest matrix is not positive definite, so neither is the fine one. "
      "Check the sign of moduli, viscosities and densities.");
  }
}

void OwnPreconditioner::rebuild()
{
  coarse_.takeCurrent();
  cycle_.setCoarseBlocks(coarse_.values());
  setup();
}

void OwnPreconditioner::apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp, double alpha,
                              double beta) const
{
  ASPERITY_ASSERT(alpha == 1 && beta == 0);
  const double norm = r.getVector(0)->norm2();
  if (!(norm > 0)) {
    z.putScalar(0);
    return;
  }
  cycle_.toRows(numbersOf(r.getLocalViewDevice(Tpetra::Access::ReadOnly)), norm, r_);
  auto const result = cycle_.run(r_, false);
  ++num_cycles_;
  cycle_.fromRows(result.z, norm, numbersOf(z.getLocalViewDevice(Tpetra::Access::OverwriteAll)));
}

multigrid::IterationResult OwnPreconditioner::solveInSinglePrecision(Vector const& r,
                                                                     double relative_tolerance,
                                                                     int max_iterations,
                                                                     Vector& c) const
{
  const double norm = r.norm2();
  const auto result = gradients_.solve(
    numbersOf(r.getLocalViewDevice(Tpetra::Access::ReadOnly)), norm, relative_tolerance,
    max_iterations, numbersOf(c.getLocalViewDevice(Tpetra::Access::OverwriteAll)));
  num_cycles_ += result.iterations;
  return result;
}
} // namespace asperity::tnnmg::detail
