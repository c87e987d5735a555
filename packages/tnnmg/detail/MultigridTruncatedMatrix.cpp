#include "tnnmg/detail/MultigridTruncatedMatrix.hpp"

#include "base/parallel/Reductions.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
using FlagVector = Tpetra::Vector<int, LocalOrdinal, GlobalOrdinal>;
using Execution = ExecutionSpace;

// 1 at the dofs of excluded nodes, on the columns of Z.
FlagVector excludedColumns(CrsMatrix const& Z, NodeDofView const& dofs, FlagView const& excluded)
{
  FlagVector of_dof(Z.getDomainMap());
  {
    const auto flags = of_dof.getLocalViewDevice(Tpetra::Access::ReadWrite);
    Kokkos::parallel_for(
      "asperity::tnnmg::markExcluded", Kokkos::RangePolicy<Execution>(0, dofs.extent_int(0)),
      KOKKOS_LAMBDA(int node) {
        for (int t = 0; t < dofs.extent_int(1); ++t) {
          flags(dofs(node, t), 0) = excluded(node);
        }
      });
  }
  FlagVector of_column(Z.getColMap());
  of_column.doImport(of_dof, Import(Z.getDomainMap(), Z.getColMap()), Tpetra::INSERT);
  return of_column;
}
} // namespace

MultigridTruncatedMatrix::MultigridTruncatedMatrix(RCP<const CrsMatrix> Z, RCP<CrsMatrix> storage)
    : Z_(std::move(Z))
    , matrix_(storage.is_null() ? rcp(new CrsMatrix(*Z_, Teuchos::Copy)) : std::move(storage))
{
}

void MultigridTruncatedMatrix::fill(MultigridNodes const& nodes, FlagView const& excluded)
{
  const auto flags = excludedColumns(*Z_, nodes.view.dofs, excluded);
  const auto without = flags.getLocalViewDevice(Tpetra::Access::ReadOnly);
  const auto source = Z_->getLocalMatrixDevice();
  const auto target = matrix_->getLocalMatrixDevice();
  const auto rows = Z_->getRowMap()->getLocalMap();
  const auto columns = Z_->getColMap()->getLocalMap();
  Kokkos::parallel_for(
    "asperity::tnnmg::truncate", Kokkos::RangePolicy<Execution>(0, source.numRows()),
    KOKKOS_LAMBDA(int row) {
      const int own = columns.getLocalElement(rows.getGlobalElement(row));
      for (auto k = source.graph.row_map(row); k < source.graph.row_map(row + 1); ++k) {
        const int column = source.graph.entries(k);
        const bool keep = column == own || (!without(own, 0) && !without(column, 0));
        target.values(k) = keep ? source.values(k) : 0.0;
      }
    });
  const auto dofs = nodes.view.dofs;
  const auto hessian = nodes.hessian;
  Kokkos::parallel_for(
    "asperity::tnnmg::addHessian", Kokkos::RangePolicy<Execution>(0, nodes.size()),
    KOKKOS_LAMBDA(int node) {
      for (int s = 0; !excluded(node) && s < dofs.extent_int(1); ++s) {
        for (int t = 0; t < dofs.extent_int(1); ++t) {
          const int row = dofs(node, s);
          const int column = columns.getLocalElement(rows.getGlobalElement(dofs(node, t)));
          for (auto k = target.graph.row_map(row); k < target.graph.row_map(row + 1); ++k) {
            if (static_cast<int>(target.graph.entries(k)) == column) {
              target.values(k) += hessian(node, s, t);
            }
          }
        }
      }
    });
}

namespace
{
// Calls visit(entry, node, s, t) for each stored entry of Z that is zero and would couple two free
// tangents of a node. Returns the number of these entries on this rank.
template <class Visit>
int forEachUncoupled(CrsMatrix const& Z, MultigridNodes const& nodes, Visit const& visit)
{
  const auto held = nodes.view.held;
  const auto matrix = Z.getLocalMatrixDevice();
  const auto rows = Z.getRowMap()->getLocalMap();
  const auto columns = Z.getColMap()->getLocalMap();
  const auto dofs = nodes.view.dofs;
  int count = 0;
  Kokkos::parallel_reduce(
    "asperity::tnnmg::findUncoupled", Kokkos::RangePolicy<Execution>(0, nodes.size()),
    KOKKOS_LAMBDA(int node, int& sum) {
      for (int s = 0; s < dofs.extent_int(1); ++s) {
        for (int t = 0; t < dofs.extent_int(1); ++t) {
          const int row = dofs(node, s);
          const int column = columns.getLocalElement(rows.getGlobalElement(dofs(node, t)));
          const bool free = !held(row) && !held(dofs(node, t));
          for (auto k = matrix.graph.row_map(row); free && k < matrix.graph.row_map(row + 1); ++k) {
            if (static_cast<int>(matrix.graph.entries(k)) == column && matrix.values(k) == 0) {
              visit(k, node, s, t);
              ++sum;
            }
          }
        }
      }
    },
    count);
  return count;
}

struct CoupleByNextToNothing
{
  decltype(std::declval<CrsMatrix>().getLocalMatrixDevice().values) values;
  NodeBlockView diagonal;

  template <class Entry>
  KOKKOS_INLINE_FUNCTION void operator()(Entry k, int node, int s, int t) const
  {
    values(k) = 1e-30 * (diagonal(node, s, s) + diagonal(node, t, t));
  }
};

struct Ignore
{
  template <class Entry>
  KOKKOS_INLINE_FUNCTION void operator()(Entry, int, int, int) const
  {
  }
};
} // namespace

RCP<CrsMatrix> withCoupledTangents(CrsMatrix const& Z, MultigridNodes const& nodes)
{
  if (sumOverRanks(forEachUncoupled(Z, nodes, Ignore()), *Z.getComm()) == 0) {
    return Teuchos::null;
  }
  const auto result = rcp(new CrsMatrix(Z, Teuchos::Copy));
  forEachUncoupled(Z, nodes,
                   CoupleByNextToNothing{result->getLocalMatrixDevice().values, nodes.diagonal});
  return result;
}
} // namespace asperity::tnnmg::detail
