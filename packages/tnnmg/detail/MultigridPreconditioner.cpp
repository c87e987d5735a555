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

// A node whose Hessian exceeds Z's block by this factor is left out of the V-cycle, where the
// Hessian would only increase rounding errors.
constexpr double stiff = 1e3;

// The Hessian of a node in the hierarchy is outdated if it differs from the current one by the
// factor `wrong`. A Hessian below the share `small` of Z's block counts as that share.
constexpr double wrong = 10;
constexpr double small = 0.1;

// 1 at nodes that the hierarchy has to leave out: removed or stiff.
FlagView nodesToExclude(MultigridNodes const& nodes)
{
  const FlagView result("asperity::tnnmg::nodesToExclude", nodes.size());
  const auto diagonal = nodes.diagonal;
  const auto hessian = nodes.hessian;
  const auto removed = nodes.removed;
  Kokkos::parallel_for(
    "asperity::tnnmg::nodesToExclude", Kokkos::RangePolicy<Execution>(0, nodes.size()),
    KOKKOS_LAMBDA(int node) {
      result(node) = removed(node) ||
                     NodeBlock(hessian, node).trace() > stiff * NodeBlock(diagonal, node).trace();
    });
  return result;
}

// x_i := blocks_i x_i, or blocks_i^T x_i, at the nodes.
void multiplyBlocks(NodeBlockView const& scaling, NodeDofView const& dofs, bool transposed,
                    MultiVector& x)
{
  const auto values = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  Kokkos::parallel_for(
    "asperity::tnnmg::scale", Kokkos::RangePolicy<Execution>(0, dofs.extent_int(0)),
    KOKKOS_LAMBDA(int node) {
      double result[max_tangents] = {};
      for (int s = 0; s < dofs.extent_int(1); ++s) {
        for (int t = 0; t < dofs.extent_int(1); ++t) {
          const double entry = transposed ? scaling(node, t, s) : scaling(node, s, t);
          result[s] += entry * values(dofs(node, t), 0);
        }
      }
      for (int s = 0; s < dofs.extent_int(1); ++s) {
        values(dofs(node, s), 0) = result[s];
      }
    });
}
} // namespace

MultigridPreconditioner::MultigridPreconditioner(RCP<const MultigridOperator> A,
                                                 RCP<const CrsMatrix> Z,
                                                 RCP<const MultiVector> near_null_space,
                                                 std::shared_ptr<const MultigridNodes> nodes,
                                                 Teuchos::ParameterList const& muelu)
    : A_(std::move(A))
    , Z_(std::move(Z))
    , nodes_(std::move(nodes))
    , smoother_(*Z_, nodes_)
    , hierarchy_(withoutHessians(), near_null_space, muelu)
    , excluded_("asperity::tnnmg::excluded", nodes_->size())
    , reference_("asperity::tnnmg::reference", nodes_->size(), nodes_->tangents(),
                 nodes_->tangents())
    , scaling_("asperity::tnnmg::scaling", nodes_->size(), nodes_->tangents(), nodes_->tangents())
    , residual_(rcp(new MultiVector(Z_->getRowMap(), 1)))
    , cycle_(rcp(new MultiVector(Z_->getRowMap(), 1)))
{
  Kokkos::deep_copy(reference_, nodes_->diagonal);
  setup();
}

RCP<const CrsMatrix> MultigridPreconditioner::withoutHessians()
{
  coupled_ = withCoupledTangents(*Z_, *nodes_);
  return coupled_.is_null() ? Z_ : RCP<const CrsMatrix>(coupled_);
}

void MultigridPreconditioner::setup()
{
  if (rebuild_from_Z_is_pending_) {
    hierarchy_.rebuild(withoutHessians());
    truncated_.reset();
    hierarchy_is_of_Z_ = true;
    rebuild_from_Z_is_pending_ = false;
  }
  smoother_.setup();
  const auto diagonal = nodes_->diagonal;
  const auto hessian = nodes_->hessian;
  const auto removed = nodes_->removed;
  const auto excluded = excluded_;
  const auto reference = reference_;
  const auto scaling = scaling_;
  Kokkos::parallel_for(
    "asperity::tnnmg::scaleBlocks", Kokkos::RangePolicy<Execution>(0, nodes_->size()),
    KOKKOS_LAMBDA(int node) {
      if (removed(node) || excluded(node)) {
        NodeBlock(diagonal.extent_int(1)).store(scaling, node);
        return;
      }
      NodeBlock block(diagonal, node);
      block += NodeBlock(hessian, node);
      const NodeBlock to = inverseOfLower(cholesky(block));
      const NodeBlock from = transpose(cholesky(NodeBlock(reference, node)));
      transposedProduct(to, from).store(scaling, node);
    });
}

double MultigridPreconditioner::outdatedShare() const
{
  const auto now = nodesToExclude(*nodes_);
  const auto before = excluded_;
  const auto diagonal = nodes_->diagonal;
  const auto hessian = nodes_->hessian;
  const auto reference = reference_;
  int changed = 0;
  Kokkos::parallel_reduce(
    "asperity::tnnmg::outdatedShare", Kokkos::RangePolicy<Execution>(0, nodes_->size()),
    KOKKOS_LAMBDA(int node, int& sum) {
      const double block = NodeBlock(diagonal, node).trace();
      const double is = NodeBlock(hessian, node).trace() + small * block;
      const double was = NodeBlock(reference, node).trace() - block + small * block;
      const bool differs = is > wrong * was || was > wrong * is;
      sum += now(node) != before(node) || (!now(node) && differs);
    },
    changed);
  const std::array<double, 2> mine = {static_cast<double>(changed),
                                      static_cast<double>(nodes_->size())};
  auto const [all_changed, all_nodes] = sumOverRanks(mine, *Z_->getComm());
  return all_nodes > 0 ? all_changed / all_nodes : 0.0;
}

void MultigridPreconditioner::rebuild()
{
  if (!truncated_) {
    truncated_.emplace(Z_, coupled_); // the hierarchy no longer needs coupled_
    coupled_ = Teuchos::null;
  }
  hierarchy_is_of_Z_ = false;
  rebuild_from_Z_is_pending_ = false;
  excluded_ = nodesToExclude(*nodes_);
  truncated_->fill(*nodes_, excluded_);
  hierarchy_.rebuild(truncated_->matrix());
  const auto diagonal = nodes_->diagonal;
  const auto hessian = nodes_->hessian;
  const auto reference = reference_;
  Kokkos::parallel_for(
    "asperity::tnnmg::reference", Kokkos::RangePolicy<Execution>(0, nodes_->size()),
    KOKKOS_LAMBDA(int node) {
      NodeBlock block(diagonal, node);
      block += NodeBlock(hessian, node);
      block.store(reference, node);
    });
  setup();
}

void MultigridPreconditioner::returnToHierarchyOfZ()
{
  rebuild_from_Z_is_pending_ = !hierarchy_is_of_Z_;
  Kokkos::deep_copy(excluded_, 0);
  Kokkos::deep_copy(reference_, nodes_->diagonal);
}

// A forward sweep gives z from r; z + S V S^T (r - A z), swept backward, is the result. As an
// operator on r it is a sum of symmetric positive semidefinite parts.
void MultigridPreconditioner::apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp,
                                    double alpha, double beta) const
{
  ASPERITY_ASSERT(alpha == 1 && beta == 0);
  z.putScalar(0);
  smoother_.sweep(MultigridSmoother::Order::forward, r, z);
  A_->apply(z, *residual_);
  residual_->update(1, r, -1);
  scale(*residual_, true);
  hierarchy_.apply(*residual_, *cycle_);
  ++num_cycles_;
  scale(*cycle_, false);
  z.update(1, *cycle_, 1);
  smoother_.sweep(MultigridSmoother::Order::backward, r, z);
}

// Replaces x by S x or by S^T x, and by zero at constrained dofs.
void MultigridPreconditioner::scale(MultiVector& x, bool transposed) const
{
  multiplyBlocks(scaling_, nodes_->view.dofs, transposed, x);
  nodes_->project(x);
}
} // namespace asperity::tnnmg::detail
