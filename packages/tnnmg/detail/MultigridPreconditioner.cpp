#include "tnnmg/detail/MultigridPreconditioner.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "tnnmg/detail/MultigridNodeBlock.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <array>
#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
using Execution = ExecutionSpace;

// On coarse levels a Hessian H counts as the parallel sum of itself and B, the block of Z,
// (H^-1 + B^-1)^-1 = B - B (H + B)^-1 B, which is no larger than either, and a removed node as B.
// Without this limit a stiff node would hold whole coarse functions, which then correct nothing.

// The Hessian of a node on coarse levels is outdated if its trace differs from that of the current
// one by more than the factor `wrong`. The part `small` of the trace of Z's block is added to both,
// so that changes of small Hessians do not count.
constexpr double wrong = 3;
constexpr double small = 0.01;

// The Hessians on coarse levels, of the current blocks.
HessianView coarseHessians(MultigridNodes const& nodes)
{
  const HessianView result("asperity::tnnmg::coarseHessian", nodes.size(), nodes.tangents(),
                           nodes.tangents());
  const auto diagonal = nodes.diagonal;
  const auto hessian = nodes.hessian;
  const auto removed = nodes.removed;
  Kokkos::parallel_for(
    "asperity::tnnmg::coarseHessians", Kokkos::RangePolicy<Execution>(0, nodes.size()),
    KOKKOS_LAMBDA(int node) {
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

MultigridPreconditioner::MultigridPreconditioner(std::shared_ptr<const MultigridFamily> family,
                                                 std::vector<double> weights,
                                                 RCP<const CrsMatrix> Z,
                                                 std::shared_ptr<const MultigridNodes> nodes)
    : Z_(std::move(Z))
    , nodes_(std::move(nodes))
    , cycle_(std::move(family), std::move(weights), *Z_, nodes_)
    , gradients_(cycle_, Z_->getComm())
    , coarse_("asperity::tnnmg::coarseHessian", nodes_->size(), nodes_->tangents(),
              nodes_->tangents())
{
  setup();
}

void MultigridPreconditioner::setup()
{
  if (is_to_forget_ && has_coarse_hessians_) {
    cycle_.setCoarseHessians({});
    has_coarse_hessians_ = false;
  }
  is_to_forget_ = false;
  cycle_.setup();
}

double MultigridPreconditioner::outdatedShare() const
{
  const auto now = coarseHessians(*nodes_);
  const auto before = coarse_;
  const auto diagonal = nodes_->diagonal;
  int changed = 0;
  Kokkos::parallel_reduce(
    "asperity::tnnmg::outdatedShare", Kokkos::RangePolicy<Execution>(0, nodes_->size()),
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
  is_to_forget_ = false;
  has_coarse_hessians_ = true;
  coarse_ = coarseHessians(*nodes_);
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), coarse_);
  cycle_.setCoarseHessians({host.data(), host.data() + host.size()});
  setup();
}

void MultigridPreconditioner::forgetHessians()
{
  is_to_forget_ = true;
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
  {
    const auto from = r.getLocalViewHost(Tpetra::Access::ReadOnly);
    auto& scaled = cycle_.r();
    for (std::size_t i = 0; i < scaled.size(); ++i) {
      scaled[i] = static_cast<float>(from(i, 0) / norm);
    }
  }
  cycle_.run(false);
  ++num_cycles_;
  const auto to = z.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < to.extent(0); ++i) {
    to(i, 0) = norm * cycle_.z()[i];
  }
}

IterationResult MultigridPreconditioner::solveLoosely(Vector const& r, double relative_tolerance,
                                                      int max_iterations, Vector& c) const
{
  const auto result = gradients_.solve(r, relative_tolerance, max_iterations, c);
  num_cycles_ += result.iterations;
  return result;
}
} // namespace asperity::tnnmg::detail
