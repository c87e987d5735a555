#include "tnnmg/multigrid/MueLuPreconditioner.hpp"

#include "base/Errors.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/multigrid/MultigridNodeBlock.hpp"

#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Vector.hpp>

#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
KOKKOS_INLINE_FUNCTION bool isStiff(NodeBlock const& hessian, NodeBlock const& diagonal)
{
  return hessian.trace() > diagonal.trace();
}

// Zero at the dofs of nodes that are removed or stiff.
void leaveOut(MultigridNodes const& nodes, MultiVector& x)
{
  const auto values = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  const auto dofs = nodes.view.dofs;
  const auto diagonal = nodes.diagonal;
  const auto hessian = nodes.hessian;
  const auto removed = nodes.removed;
  Kokkos::parallel_for(
    "asperity::tnnmg::leaveOut", RangePolicy(0, nodes.size()), KOKKOS_LAMBDA(int node) {
      const bool leave =
        removed(node) || isStiff(NodeBlock(hessian, node), NodeBlock(diagonal, node));
      for (int t = 0; leave && t < dofs.extent_int(1); ++t) {
        values(dofs(node, t), 0) = 0;
      }
    });
}

// z = (B + H)^-1 r at the stiff nodes.
void solveStiff(MultigridNodes const& nodes, MultiVector const& r, MultiVector& z)
{
  const auto from = r.getLocalViewDevice(Tpetra::Access::ReadOnly);
  const auto to = z.getLocalViewDevice(Tpetra::Access::ReadWrite);
  const auto dofs = nodes.view.dofs;
  const auto diagonal = nodes.diagonal;
  const auto hessian = nodes.hessian;
  const auto removed = nodes.removed;
  Kokkos::parallel_for(
    "asperity::tnnmg::solveStiff", RangePolicy(0, nodes.size()), KOKKOS_LAMBDA(int node) {
      NodeBlock sum(hessian, node);
      const NodeBlock B(diagonal, node);
      if (removed(node) || !isStiff(sum, B)) {
        return;
      }
      sum += B;
      const NodeBlock inverted = inverse(sum);
      for (int s = 0; s < inverted.size; ++s) {
        double value = 0;
        for (int t = 0; t < inverted.size; ++t) {
          value += inverted.entry[s][t] * from(dofs(node, t), 0);
        }
        to(dofs(node, s), 0) = value;
      }
    });
}

// Adds H to the rows of nodes that stay, and B to those of the others, whose entries are zero.
// Couplings that the graph lacks are left out.
void addBlocks(MultigridNodes const& nodes, CrsMatrix& A)
{
  const auto matrix = A.getLocalMatrixDevice();
  const auto dofs = nodes.view.dofs;
  const auto diagonal = nodes.diagonal;
  const auto hessian = nodes.hessian;
  const auto removed = nodes.removed;
  Kokkos::parallel_for(
    "asperity::tnnmg::addBlocks", RangePolicy(0, nodes.size()), KOKKOS_LAMBDA(int node) {
      const NodeBlock H(hessian, node), B(diagonal, node);
      const NodeBlock& added = removed(node) || isStiff(H, B) ? B : H;
      for (int s = 0; s < added.size; ++s) {
        for (int t = 0; t < added.size; ++t) {
          const LocalOrdinal column = dofs(node, t);
          matrix.sumIntoValues(dofs(node, s), &column, 1, &added.entry[s][t]);
        }
      }
    });
}
} // namespace

MueLuPreconditioner::MueLuPreconditioner(std::vector<RCP<const CrsMatrix>> P,
                                         Teuchos::ParameterList muelu, RCP<const CrsMatrix> Z,
                                         std::shared_ptr<const MultigridNodes> nodes)
    : P_(std::move(P))
    , muelu_(std::move(muelu))
    , Z_(std::move(Z))
    , nodes_(std::move(nodes))
    , coarse_(nodes_)
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

double MueLuPreconditioner::outdatedShare() const { return coarse_.outdatedShare(*Z_->getComm()); }

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
