#include "tnnmg/correction/MultigridNodes.hpp"

#include "base/Errors.hpp"
#include "tnnmg/SparseRateMatrix.hpp"
#include "tnnmg/correction/MultigridNodeBlock.hpp"

#include <Tpetra_MultiVector.hpp>

namespace asperity::tnnmg::detail
{
void MultigridNodes::set(NonlinearBlocks const& blocks)
{
  ASPERITY_ASSERT(static_cast<int>(blocks.truncated.extent(0)) == size() &&
                  static_cast<int>(blocks.hessian.extent(0)) == size());
  const auto given = blocks;
  const auto target = hessian;
  const auto flags = removed;
  const int num_tangents = tangents();
  Kokkos::parallel_for(
    "asperity::tnnmg::takeBlocks", RangePolicy(0, size()), KOKKOS_LAMBDA(int node) {
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
    "asperity::tnnmg::projectHeld", RangePolicy(0, rows.extent_int(0)),
    KOKKOS_LAMBDA(int k) { values(rows(k), 0) = 0; });
  const auto node_dofs = view.dofs;
  const auto flags = removed;
  Kokkos::parallel_for(
    "asperity::tnnmg::projectRemoved", RangePolicy(0, size()), KOKKOS_LAMBDA(int node) {
      for (int t = 0; flags(node) && t < node_dofs.extent_int(1); ++t) {
        values(node_dofs(node, t), 0) = 0;
      }
    });
}

MultigridNodes makeNodes(CrsMatrix const& Z, NonlinearNodes const& view, IndexView const& held_rows)
{
  const int num_nodes = view.numNodes(), tangents = view.blockSize();
  ASPERITY_ASSERT(tangents <= max_tangents);
  return {view, held_rows, diagonalBlocks(Z, view),
          HessianView("asperity::tnnmg::hessian", num_nodes, tangents, tangents),
          FlagView("asperity::tnnmg::removed", num_nodes)};
}
} // namespace asperity::tnnmg::detail
