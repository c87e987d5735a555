#include "tnnmg/detail/MultigridSmoother.hpp"

#include "tnnmg/detail/MultigridNodeBlock.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
using HostDofs = Kokkos::View<const LocalOrdinal**, Kokkos::LayoutRight, Kokkos::HostSpace>;
using Execution = ExecutionSpace;

// The rows of Z at the nodes' dofs, T successive rows for each node, under their own global ids.
RCP<const CrsMatrix> extractRows(CrsMatrix const& Z, HostDofs const& dofs)
{
  std::vector<GlobalOrdinal> ids;
  for (int node = 0; node < dofs.extent_int(0); ++node) {
    for (int t = 0; t < dofs.extent_int(1); ++t) {
      ids.push_back(Z.getRowMap()->getGlobalElement(dofs(node, t)));
    }
  }
  const auto num_global =
    Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(); // to be computed
  const RCP<const Map> map =
    rcp(new Map(num_global, Teuchos::arrayViewFromVector(ids), 0, Z.getComm()));
  return Tpetra::importAndFillCompleteCrsMatrix<CrsMatrix>(
    Teuchos::rcpFromRef(Z), Import(Z.getRowMap(), map), Z.getDomainMap(), map);
}

// z += (diagonal + Hessian)^-1 (r - (Z + H) z) at the nodes of one colour.
struct RelaxRows
{
  using ConstColumns = MultiVector::dual_view_type::t_dev::const_type;

  CrsMatrix::local_matrix_device_type rows; // of Z, T successive ones per node
  NodeDofView dofs;
  NodeBlockView hessian, inverse;
  ConstColumns before, right; // z at the columns of the rows, r
  MultiVector::dual_view_type::t_dev after;
  IndexView colour;

  KOKKOS_FUNCTION void operator()(int k) const
  {
    const int node = colour(k);
    const int tangents = dofs.extent_int(1);
    double residual[max_tangents] = {};
    for (int s = 0; s < tangents; ++s) {
      const auto row = rows.rowConst(node * tangents + s);
      residual[s] = right(dofs(node, s), 0);
      for (int entry = 0; entry < row.length; ++entry) {
        residual[s] -= row.value(entry) * before(row.colidx(entry), 0);
      }
      for (int t = 0; t < tangents; ++t) {
        residual[s] -= hessian(node, s, t) * after(dofs(node, t), 0);
      }
    }
    for (int s = 0; s < tangents; ++s) {
      for (int t = 0; t < tangents; ++t) {
        after(dofs(node, s), 0) += inverse(node, s, t) * residual[t];
      }
    }
  }
};
} // namespace

MultigridSmoother::MultigridSmoother(CrsMatrix const& Z,
                                     std::shared_ptr<const MultigridNodes> nodes)
    : nodes_(std::move(nodes))
{
  rows_ =
    extractRows(Z, Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), nodes_->view.dofs));
  columns_ = rcp(new Import(rows_->getDomainMap(), rows_->getColMap()));
  neighbours_ = rcp(new MultiVector(rows_->getColMap(), 1));
  inverse_ = NodeBlockView("asperity::tnnmg::inverse", nodes_->size(), nodes_->tangents(),
                           nodes_->tangents());
}

void MultigridSmoother::setup()
{
  const auto diagonal = nodes_->diagonal;
  const auto hessian = nodes_->hessian;
  const auto removed = nodes_->removed;
  const auto inverses = inverse_;
  Kokkos::parallel_for(
    "asperity::tnnmg::invertBlocks", Kokkos::RangePolicy<Execution>(0, nodes_->size()),
    KOKKOS_LAMBDA(int node) {
      if (removed(node)) {
        NodeBlock(diagonal.extent_int(1)).store(inverses, node);
        return;
      }
      NodeBlock block(diagonal, node);
      block += NodeBlock(hessian, node);
      inverse(block).store(inverses, node);
    });
}

void MultigridSmoother::sweep(Order order, MultiVector const& r, MultiVector& z) const
{
  auto const& colours = nodes_->view.colours;
  if (order == Order::forward) {
    for (auto const& colour : colours) {
      relax(colour, r, z);
    }
  } else {
    for (auto colour = colours.rbegin(); colour != colours.rend(); ++colour) {
      relax(*colour, r, z);
    }
  }
}

void MultigridSmoother::relax(IndexView const& colour, MultiVector const& r, MultiVector& z) const
{
  neighbours_->doImport(z, *columns_, Tpetra::INSERT);
  const RelaxRows kernel{rows_->getLocalMatrixDevice(),
                         nodes_->view.dofs,
                         nodes_->hessian,
                         inverse_,
                         neighbours_->getLocalViewDevice(Tpetra::Access::ReadOnly),
                         r.getLocalViewDevice(Tpetra::Access::ReadOnly),
                         z.getLocalViewDevice(Tpetra::Access::ReadWrite),
                         colour};
  Kokkos::parallel_for("asperity::tnnmg::relax",
                       Kokkos::RangePolicy<Execution>(0, colour.extent_int(0)), kernel);
}
} // namespace asperity::tnnmg::detail
