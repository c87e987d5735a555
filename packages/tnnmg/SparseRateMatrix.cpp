#include "tnnmg/SparseRateMatrix.hpp"

#include "base/MatrixProducts.hpp"
#include "base/parallel/Reductions.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/OrderedSums.hpp"

#include <Tpetra_Map.hpp>

#include <string>
#include <utility>

namespace asperity::tnnmg
{
namespace
{
using LocalMatrix = CrsMatrix::local_matrix_device_type;

const std::string label_residual = "asperity::tnnmg::modelResidual";

RCP<const Vector> diagonalOf(CrsMatrix const& Z)
{
  const auto diagonal = rcp(new Vector(Z.getDomainMap()));
  Z.getLocalDiagCopy(*diagonal);
  return diagonal;
}

// residual(node, k) = b - sum_j Z_kj v_j + curvature v at the rows of the given nodes. This is the
// linear term of the model at v = 0; it is zero in the components that are held.
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
    label_residual, RangePolicy(0, which.extent(0)), KOKKOS_LAMBDA(int i) {
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

// columns = Z d for a d that is zero except at the nonlinear nodes, on Z's column map. Z is
// symmetric, so that the rows of these nodes serve as their columns.
void sumColumns(LocalMatrix const& matrix, NonlinearNodes const& nodes, ConstBlockView const& d,
                Vector& columns)
{
  columns.putScalar(0);
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
} // namespace

HessianView diagonalBlocks(CrsMatrix const& Z, NonlinearNodes const& nodes)
{
  const int size = nodes.blockSize();
  const HessianView blocks("asperity::tnnmg::diagonalBlocks", nodes.numNodes(), size, size);
  auto const matrix = Z.getLocalMatrixDevice();
  auto const dofs = nodes.dofs;
  Kokkos::parallel_for(
    "asperity::tnnmg::diagonalBlocks", RangePolicy(0, nodes.numNodes()), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        const int row = dofs(node, k);
        for (auto e = matrix.graph.row_map(row); e < matrix.graph.row_map(row + 1); ++e) {
          for (int l = 0; l < size; ++l) {
            if (matrix.graph.entries(e) == dofs(node, l)) {
              blocks(node, k, l) = matrix.values(e);
            }
          }
        }
      }
    });
  return blocks;
}

SparseRateMatrix::SparseRateMatrix(RCP<const CrsMatrix> Z, NonlinearNodes const& nodes)
    : RateMatrix(nodes, Z->getDomainMap(), Z->getColMap(), diagonalOf(*Z),
                 diagonalBlocks(*Z, nodes))
    , Z_(std::move(Z))
    , exchange_(*Z_, nodes)
    , work_(rcp(new Vector(columns())))
{
  const int mine = nodes.numNodes() * nodes.blockSize();
  has_few_nodes_ =
    8. * sumOverRanks(mine, *Z_->getComm()) < static_cast<double>(Z_->getGlobalNumRows());
}

void SparseRateMatrix::copyWithGhosts(Vector const& x) const
{
  {
    auto const from = x.getLocalViewDevice(Tpetra::Access::ReadOnly);
    auto const to = work_->getLocalViewDevice(Tpetra::Access::OverwriteAll);
    Kokkos::deep_copy(Kokkos::subview(to, std::make_pair(std::size_t(0), from.extent(0)), 0),
                      Kokkos::subview(from, Kokkos::ALL, 0));
  }
  exchange_.shareBody(*work_);
}

void SparseRateMatrix::apply(Vector const& x, Vector& y) const
{
  if (Z_->getCrsGraph()->getImporter().is_null()) {
    return multiply({{*Z_, x, y}});
  }
  copyWithGhosts(x);
  multiply({{*Z_, *work_, y}});
}

void SparseRateMatrix::sumMagnitudes(Vector const& x, Vector& y) const
{
  copyWithGhosts(x);
  auto const matrix = Z_->getLocalMatrixDevice();
  auto const from = work_->getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const to = y.getLocalViewDevice(Tpetra::Access::OverwriteAll);
  Kokkos::parallel_for(
    "asperity::tnnmg::sumMagnitudes", RangePolicy(0, to.extent(0)), KOKKOS_LAMBDA(int row) {
      double sum = 0;
      for (auto e = matrix.graph.row_map(row); e < matrix.graph.row_map(row + 1); ++e) {
        sum += math::fabs(matrix.values(e) * from(matrix.graph.entries(e), 0));
      }
      to(row, 0) = sum;
    });
}

int SparseRateMatrix::sweep(NodalProblem const& problem, Vector const& b, Vector& v_columns,
                            Vector&, BlockView const& blocks, BlockView const& residual) const
{
  // Tpetra gives the local matrix only once, because that costs as much as using it.
  auto const matrix = Z_->getLocalMatrixDevice();
  auto const& colours = nodes().colours;
  int failures = 0;
  exchange_.share(v_columns);
  for (std::size_t k = 0; k < colours.size(); ++k) {
    if (colours[k].extent(0) > 0) {
      modelResidual(matrix, nodes(), colours[k], curvature(), b, v_columns, residual);
      failures += problem.minimise(colours[k], curvature(), residual, blocks);
      scatter(nodes(), colours[k], blocks, v_columns);
    }
    exchange_.shareColour(k, v_columns);
  }
  return failures;
}

// By the columns of the nodes that have changed: much less work than a product with Z, unless most
// nodes are nonlinear.
void SparseRateMatrix::finishSweeps(ConstBlockView const& d, Vector const& b, Vector const& v,
                                    Vector& r) const
{
  if (!has_few_nodes_) {
    residual(b, v, r);
    return;
  }
  sumColumns(Z_->getLocalMatrixDevice(), nodes(), d, *work_);
  r.update(-1, *work_->offsetView(rows(), 0)->getVector(0), 1);
  exchange_.subtractGhosts(*work_, r);
}
} // namespace asperity::tnnmg
