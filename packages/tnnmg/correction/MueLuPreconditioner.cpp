#include "tnnmg/correction/MueLuPreconditioner.hpp"

#include "base/Errors.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/correction/MultigridNodeBlock.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Vector.hpp>

#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
// What kernels read of the nodes.
struct NodeViews
{
  explicit NodeViews(MultigridNodes const& nodes)
      : dofs(nodes.view.dofs)
      , diagonal(nodes.diagonal)
      , hessian(nodes.hessian)
      , removed(nodes.removed)
  {
  }

  KOKKOS_INLINE_FUNCTION NodeBlock B(int node) const { return {diagonal, node}; }
  KOKKOS_INLINE_FUNCTION NodeBlock H(int node) const { return {hessian, node}; }
  KOKKOS_INLINE_FUNCTION bool isRemoved(int node) const { return removed(node) != 0; }
  KOKKOS_INLINE_FUNCTION bool isStiff(int node) const { return H(node).trace() > B(node).trace(); }

  NodeDofView dofs;
  HessianView diagonal, hessian;
  FlagView removed;
};

// Zero at the dofs of nodes that are removed or stiff.
void leaveOut(MultigridNodes const& nodes, MultiVector& x)
{
  const auto values = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  const NodeViews node_views(nodes);
  Kokkos::parallel_for(
    "asperity::tnnmg::leaveOut", RangePolicy(0, nodes.size()), KOKKOS_LAMBDA(int node) {
      const bool leave = node_views.isRemoved(node) || node_views.isStiff(node);
      for (int t = 0; leave && t < node_views.dofs.extent_int(1); ++t) {
        values(node_views.dofs(node, t), 0) = 0;
      }
    });
}

// z = (B + H)^-1 r at the stiff nodes.
void solveStiff(MultigridNodes const& nodes, MultiVector const& r, MultiVector& z)
{
  const auto from = r.getLocalViewDevice(Tpetra::Access::ReadOnly);
  const auto to = z.getLocalViewDevice(Tpetra::Access::ReadWrite);
  const NodeViews node_views(nodes);
  Kokkos::parallel_for(
    "asperity::tnnmg::solveStiff", RangePolicy(0, nodes.size()), KOKKOS_LAMBDA(int node) {
      if (node_views.isRemoved(node) || !node_views.isStiff(node)) {
        return;
      }
      NodeBlock sum = node_views.H(node);
      sum += node_views.B(node);
      const NodeBlock inverted = inverse(sum);
      for (int s = 0; s < inverted.size; ++s) {
        double value = 0;
        for (int t = 0; t < inverted.size; ++t) {
          value += inverted.entry[s][t] * from(node_views.dofs(node, t), 0);
        }
        to(node_views.dofs(node, s), 0) = value;
      }
    });
}

// Adds H to the rows of nodes that stay, and B to those of the others, whose entries are zero.
// Couplings that the graph lacks are left out.
void addBlocks(MultigridNodes const& nodes, CrsMatrix& A)
{
  const auto matrix = A.getLocalMatrixDevice();
  const NodeViews node_views(nodes);
  Kokkos::parallel_for(
    "asperity::tnnmg::addBlocks", RangePolicy(0, nodes.size()), KOKKOS_LAMBDA(int node) {
      const NodeBlock added = node_views.isRemoved(node) || node_views.isStiff(node)
                                ? node_views.B(node)
                                : node_views.H(node);
      for (int s = 0; s < added.size; ++s) {
        for (int t = 0; t < added.size; ++t) {
          const LocalOrdinal column = node_views.dofs(node, t);
          matrix.sumIntoValues(node_views.dofs(node, s), &column, 1, &added.entry[s][t]);
        }
      }
    });
}
} // namespace

MueLuPreconditioner::MueLuPreconditioner(std::vector<RCP<const CrsMatrix>> P,
                                         Teuchos::ParameterList muelu, RCP<const CrsMatrix> Z,
                                         std::shared_ptr<const MultigridNodes> nodes)
    : Preconditioner(std::move(Z), std::move(nodes))
    , P_(std::move(P))
    , muelu_(std::move(muelu))
    , cycle_(Z_, P_, muelu_)
{
}

RCP<const CrsMatrix> MueLuPreconditioner::withHessians() const
{
  const auto A = rcp(new CrsMatrix(*Z_, Teuchos::Copy));
  Vector coupled(Z_->getRowMap());
  coupled.putScalar(1);
  leaveOut(*nodes_, coupled);
  A->leftScale(coupled);
  A->rightScale(coupled);
  addBlocks(*nodes_, *A);
  return A;
}

void MueLuPreconditioner::setup()
{
  if (coarse_.forgotten()) {
    cycle_ = MueLuHierarchy(Z_, P_, muelu_);
  }
}

void MueLuPreconditioner::rebuild()
{
  coarse_.takeCurrent();
  cycle_ = MueLuHierarchy(withHessians(), P_, muelu_);
}

void MueLuPreconditioner::apply(MultiVector const& r, MultiVector& z, Teuchos::ETransp,
                                double alpha, double beta) const
{
  ASPERITY_ASSERT(alpha == 1 && beta == 0);
  MultiVector soft(r, Teuchos::Copy);
  leaveOut(*nodes_, soft);
  cycle_.apply(soft, z);
  ++num_cycles_;
  leaveOut(*nodes_, z);
  nodes_->project(z);
  solveStiff(*nodes_, r, z);
}

// The copy of Z, and as much for the coarse matrices.
std::size_t MueLuPreconditioner::bytes() const
{
  return 2 * (sizeof(double) + sizeof(LocalOrdinal)) * numLocalEntries(*Z_);
}
} // namespace asperity::tnnmg::detail
