#include "tnnmg/GaussSeidel.hpp"

#include "base/Errors.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/detail/OrderedSums.hpp"

#include <Tpetra_Map.hpp>

#include <string>

namespace asperity::tnnmg
{
namespace
{
using Policy = Kokkos::RangePolicy<ExecutionSpace>;

// Labels are made once: a sweep launches hundreds of kernels.
const std::string label_residual = "asperity::tnnmg::modelResidual";
const std::string label_gather = "asperity::tnnmg::gather";
const std::string label_scatter = "asperity::tnnmg::scatter";
} // namespace

NodeView nodalCurvature(CrsMatrix const& Z, NonlinearNodes const& nodes)
{
  NodeView curvature("asperity::tnnmg::curvature", nodes.numNodes());
  auto const matrix = Z.getLocalMatrixDevice();
  auto const dofs = nodes.dofs;
  auto const held = nodes.held;
  const int size = nodes.blockSize();
  Kokkos::parallel_for(
    "asperity::tnnmg::nodalCurvature", Policy(0, nodes.numNodes()), KOKKOS_LAMBDA(int node) {
      double block[3][3] = {};
      for (int k = 0; k < size; ++k) {
        const int row = dofs(node, k);
        for (auto e = matrix.graph.row_map(row); e < matrix.graph.row_map(row + 1); ++e) {
          for (int l = 0; l < size; ++l) {
            const bool free = !held(dofs(node, k)) && !held(dofs(node, l));
            if (free && matrix.graph.entries(e) == dofs(node, l)) {
              block[k][l] = matrix.values(e);
            }
          }
        }
      }
      // The result is exact for one and two components; for three it is Gershgorin's bound, which
      // is no smaller.
      if (size == 1) {
        curvature(node) = block[0][0];
      } else if (size == 2) {
        const double mean = (block[0][0] + block[1][1]) / 2;
        const double half = (block[0][0] - block[1][1]) / 2;
        curvature(node) = mean + math::sqrt(half * half + block[0][1] * block[0][1]);
      } else {
        for (int k = 0; k < size; ++k) {
          double sum = 0;
          for (int l = 0; l < size; ++l) {
            sum += block[k][l] < 0 ? -block[k][l] : block[k][l];
          }
          curvature(node) = sum > curvature(node) ? sum : curvature(node);
        }
      }
    });
  return curvature;
}

void modelResidual(LocalMatrix const& matrix, NonlinearNodes const& nodes, IndexView const& which,
                   ConstNodeView const& curvature, Vector const& b, Vector const& v_columns,
                   BlockView const& residual)
{
  auto const right_side = b.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const v = v_columns.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const dofs = nodes.dofs;
  auto const held = nodes.held;
  const int size = nodes.blockSize();
  Kokkos::parallel_for(
    label_residual, Policy(0, which.extent(0)), KOKKOS_LAMBDA(int i) {
      const int node = which(i);
      for (int k = 0; k < size; ++k) {
        const int row = dofs(node, k);
        double sum = 0;
        for (auto e = matrix.graph.row_map(row); e < matrix.graph.row_map(row + 1); ++e) {
          sum += matrix.values(e) * v(matrix.graph.entries(e), 0);
        }
        residual(node, k) =
          held(dofs(node, k)) ? 0 : right_side(row, 0) - sum + curvature(node) * v(row, 0);
      }
    });
}

CoupledSystem coupledSystem(CrsMatrix const& Z, NonlinearNodes const& nodes,
                            ConstNodeView const& curvature, Vector& r)
{
  auto const matrix = Z.getLocalMatrixDevice();
  const std::size_t size = matrix.numRows();
  ASPERITY_ASSERT(matrix.nnz() == size * size);
  auto const force = r.getLocalViewDevice(Tpetra::Access::ReadWrite);
  return {ConstBlockView(matrix.values.data(), size, size),
          BlockView(force.data(), nodes.numNodes(), nodes.blockSize()), nodes.held, curvature};
}

void gather(NonlinearNodes const& nodes, Vector const& v, BlockView const& blocks)
{
  auto const values = v.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const dofs = nodes.dofs;
  const int size = nodes.blockSize();
  Kokkos::parallel_for(
    label_gather, Policy(0, nodes.numNodes()), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        blocks(node, k) = values(dofs(node, k), 0);
      }
    });
}

void scatter(NonlinearNodes const& nodes, IndexView const& which, ConstBlockView const& blocks,
             Vector& v)
{
  auto const values = v.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const dofs = nodes.dofs;
  const int size = nodes.blockSize();
  Kokkos::parallel_for(
    label_scatter, Policy(0, which.extent(0)), KOKKOS_LAMBDA(int i) {
      const int node = which(i);
      for (int k = 0; k < size; ++k) {
        values(dofs(node, k), 0) = blocks(node, k);
      }
    });
}

void subtractColumns(CrsMatrix const& Z, NonlinearNodes const& nodes, FaultColumns const& exchange,
                     ConstBlockView const& d, Vector& columns, Vector& r)
{
  columns.putScalar(0);
  {
    auto const matrix = Z.getLocalMatrixDevice();
    auto const sum = columns.getLocalViewDevice(Tpetra::Access::ReadWrite);
    auto const dofs = nodes.dofs;
    const int size = nodes.blockSize();
    detail::addInOrder(
      nodes.numNodes(), KOKKOS_LAMBDA(int node) {
        for (int k = 0; k < size; ++k) {
          const int row = dofs(node, k);
          const double change = d(node, k);
          for (auto e = matrix.graph.row_map(row); change != 0 && e < matrix.graph.row_map(row + 1);
               ++e) {
            Kokkos::atomic_add(&sum(matrix.graph.entries(e), 0), matrix.values(e) * change);
          }
        }
      });
  }
  auto const owned = columns.offsetView(Z.getDomainMap(), 0)->getVector(0);
  r.update(-1, *owned, 1);
  exchange.subtractGhosts(columns, r);
}
} // namespace asperity::tnnmg
