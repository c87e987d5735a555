#include "tnnmg/correction/CoarseHessians.hpp"

#include "base/parallel/Reductions.hpp"
#include "tnnmg/correction/MultigridNodeBlock.hpp"

#include <array>
#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
constexpr double wrong = 3;    // the factor between traces
constexpr double small = 0.01; // of the trace of Z's block

// What the current blocks are on coarse levels.
HessianView limited(MultigridNodes const& nodes)
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

CoarseHessians::CoarseHessians(std::shared_ptr<const MultigridNodes> nodes)
    : nodes_(std::move(nodes))
    , values_("asperity::tnnmg::coarseHessian", nodes_->size(), nodes_->tangents(),
              nodes_->tangents())
{
}

double CoarseHessians::outdatedShare(Communicator const& communicator) const
{
  const auto now = limited(*nodes_);
  const auto before = values_;
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
  auto const [all_changed, all_nodes] = sumOverRanks(mine, communicator);
  return all_nodes > 0 ? all_changed / all_nodes : 0.0;
}

void CoarseHessians::takeCurrent()
{
  values_ = limited(*nodes_);
  taken_ = true;
  forgets_ = false;
}

void CoarseHessians::forget()
{
  Kokkos::deep_copy(values_, 0);
  forgets_ = taken_;
}

bool CoarseHessians::forgotten()
{
  if (forgets_) {
    taken_ = false;
  }
  return std::exchange(forgets_, false);
}
} // namespace asperity::tnnmg::detail
