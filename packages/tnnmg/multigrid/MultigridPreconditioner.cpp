#include "tnnmg/multigrid/MultigridPreconditioner.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/multigrid/MultigridNodeBlock.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <array>
#include <utility>
#include <vector>

namespace asperity::tnnmg::detail
{
namespace
{
// On coarse levels a Hessian H counts as the parallel sum of itself and B, the block of Z,
// (H^-1 + B^-1)^-1 = B - B (H + B)^-1 B, which is no larger than either, and a removed node as B.
// Without this limit a stiff node would hold whole coarse functions, which then correct nothing.

// The Hessian of a node on coarse levels is outdated if its trace differs from that of the current
// one by more than the factor `wrong`. The part `small` of the trace of Z's block is added to both,
// so that changes of small Hessians do not count.
constexpr double wrong = 3;
constexpr double small = 0.01;

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

// The Hessians on coarse levels, of the current blocks.
HessianView coarseHessians(MultigridNodes const& nodes)
{
  const HessianView result("asperity::tnnmg::coarseHessian", nodes.size(), nodes.tangents(),
                           nodes.tangents());
  const auto diagonal = nodes.diagonal;
  const auto hessian = nodes.hessian;
  const auto removed = nodes.removed;
  Kokkos::parallel_for(
    "asperity::tnnmg::coarseHessians", RangePolicy(0, nodes.size()), KOKKOS_LAMBDA(int node) {
      NodeBlock B(diagonal, node);
      if (!removed(node)) {
        NodeBlock sum(hessian, node);
        sum += B;
        NodeBlock taken = transposedProduct(B, transposedProduct(inverse(sum), B));
        taken *= -1;
        B += taken;
      }
      B.store(result, node);
    });
  return result;
}
} // namespace

MultigridPreconditioner::MultigridPreconditioner(MultigridHierarchy const& hierarchy,
                                                 std::vector<double> const& weights,
                                                 RCP<const CrsMatrix> Z,
                                                 std::shared_ptr<const MultigridNodes> nodes)
    : Z_(std::move(Z))
    , nodes_(std::move(nodes))
    , cycle_(hierarchy.shared(), weights, hierarchy.finestBlocks(*Z_),
             flagsOf(nodes_->held_rows, numLocalRows(*Z_)), nodes_->view.dofs)
    , gradients_(cycle_, sumOver(Z_->getComm()))
    , coarse_("asperity::tnnmg::coarseHessian", nodes_->size(), nodes_->tangents(),
              nodes_->tangents())
    , r_(multigrid::makeNumbers(cycle_.rows()))
{
  setup();
}

void MultigridPreconditioner::setup()
{
  if (forgets_ && has_coarse_hessians_) {
    cycle_.setCoarseBlocks(coarse_); // zero
    has_coarse_hessians_ = false;
  }
  forgets_ = false;
  if (!cycle_.setup(nodes_->hessian, nodes_->removed)) {
    throw SolveError(
      "Multigrid: the coarsest matrix is not positive definite, so neither is the fine one. "
      "Check the sign of moduli, viscosities and densities.");
  }
}

double MultigridPreconditioner::outdatedShare() const
{
  const auto now = coarseHessians(*nodes_);
  const auto before = coarse_;
  const auto diagonal = nodes_->diagonal;
  int changed = 0;
  Kokkos::parallel_reduce(
    "asperity::tnnmg::outdatedShare", RangePolicy(0, nodes_->size()),
    KOKKOS_LAMBDA(int node, int& sum) {
      const double least = small * NodeBlock(diagonal, node).trace();
      const double is = NodeBlock(now, node).trace() + least;
      const double was = NodeBlock(before, node).trace() + least;
      sum += is > wrong * was || was > wrong * is;
    },
    changed);
  const std::array<double, 2> mine = {static_cast<double>(changed),
                                      static_cast<double>(nodes_->size())};
  auto const [all_changed, all_nodes] = sumOverRanks(mine, *Z_->getComm());
  return all_nodes > 0 ? all_changed / all_nodes : 0.0;
}

void MultigridPreconditioner::rebuild()
{
  forgets_ = false;
  has_coarse_hessians_ = true;
  coarse_ = coarseHessians(*nodes_);
  cycle_.setCoarseBlocks(coarse_);
  setup();
}

void MultigridPreconditioner::forgetHessians()
{
  forgets_ = true;
  Kokkos::deep_copy(coarse_, 0);
}

void MultigridPreconditioner::apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp,
                                    double alpha, double beta) const
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

multigrid::IterationResult MultigridPreconditioner::solveLoosely(Vector const& r,
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
