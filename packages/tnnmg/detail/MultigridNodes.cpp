#include "tnnmg/detail/MultigridNodes.hpp"

#include "base/Errors.hpp"
#include "tnnmg/detail/MultigridNodeBlock.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

namespace asperity::tnnmg::detail
{
using Execution = ExecutionSpace;

void MultigridNodes::set(NonlinearBlocks const& blocks)
{
  ASPERITY_ASSERT(static_cast<int>(blocks.truncated.extent(0)) == size() &&
                  static_cast<int>(blocks.hessian.extent(0)) == size());
  const auto given = blocks;
  const auto target = hessian;
  const auto flags = removed;
  const int num_tangents = tangents();
  Kokkos::parallel_for(
    "asperity::tnnmg::takeBlocks", Kokkos::RangePolicy<Execution>(0, size()),
    KOKKOS_LAMBDA(int node) {
      flags(node) = given.truncated(node);
      for (int s = 0; s < num_tangents; ++s) {
        for (int t = 0; t < num_tangents; ++t) {
          target(node, s, t) = flags(node) ? 0.0 : given.hessian(node, s, t);
        }
      }
    });
}

void MultigridNodes::project(MultiVector& x) const
{
  const auto values = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  const auto rows = held_rows;
  Kokkos::parallel_for(
    "asperity::tnnmg::projectHeld", Kokkos::RangePolicy<Execution>(0, rows.extent_int(0)),
    KOKKOS_LAMBDA(int k) { values(rows(k), 0) = 0; });
  const auto node_dofs = view.dofs;
  const auto flags = removed;
  Kokkos::parallel_for(
    "asperity::tnnmg::projectRemoved", Kokkos::RangePolicy<Execution>(0, size()),
    KOKKOS_LAMBDA(int node) {
      for (int t = 0; flags(node) && t < node_dofs.extent_int(1); ++t) {
        values(node_dofs(node, t), 0) = 0;
      }
    });
}

MultigridNodes makeNodes(CrsMatrix const& Z, NonlinearNodes const& view, IndexView const& held_rows)
{
  const auto dofs = view.dofs;
  const int num_nodes = dofs.extent_int(0);
  const int tangents = dofs.extent_int(1);
  ASPERITY_ASSERT(tangents <= max_tangents);
  MultigridNodes nodes{view, held_rows,
                       NodeBlockView("asperity::tnnmg::diagonal", num_nodes, tangents, tangents),
                       NodeBlockView("asperity::tnnmg::hessian", num_nodes, tangents, tangents),
                       FlagView("asperity::tnnmg::removed", num_nodes)};
  const auto matrix = Z.getLocalMatrixDevice();
  const auto rows = Z.getRowMap()->getLocalMap();
  const auto columns = Z.getColMap()->getLocalMap();
  const auto diagonal = nodes.diagonal;
  Kokkos::parallel_for(
    "asperity::tnnmg::readDiagonal", Kokkos::RangePolicy<Execution>(0, num_nodes),
    KOKKOS_LAMBDA(int node) {
      for (int s = 0; s < tangents; ++s) {
        const auto row = matrix.row(dofs(node, s));
        for (int k = 0; k < row.length; ++k) {
          for (int t = 0; t < tangents; ++t) {
            if (columns.getGlobalElement(row.colidx(k)) == rows.getGlobalElement(dofs(node, t))) {
              diagonal(node, s, t) = row.value(k);
            }
          }
        }
      }
    });
  return nodes;
}
} // namespace asperity::tnnmg::detail
