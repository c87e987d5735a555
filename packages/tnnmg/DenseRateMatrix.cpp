#include "tnnmg/DenseRateMatrix.hpp"

#include <Eigen/Core>
#include <Tpetra_Map.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::tnnmg
{
namespace
{
NonlinearNodes coupledNodes(int size, int block_size, std::vector<int> const& held)
{
  const int num_nodes = size / block_size;
  const Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> dofs("asperity::tnnmg::dofs",
                                                                            num_nodes, block_size);
  auto const host = Kokkos::create_mirror_view(dofs);
  std::vector<int> free;
  for (int node = 0; node < num_nodes; ++node) {
    for (int k = 0; k < block_size; ++k) {
      host(node, k) = node * block_size + k;
    }
    auto const first = held.begin() + node * block_size;
    if (std::find(first, first + block_size, 0) != first + block_size) {
      free.push_back(node);
    }
  }
  Kokkos::deep_copy(dofs, host);
  return {
    dofs, toDevice(held, "asperity::tnnmg::held"), {toDevice(free, "asperity::tnnmg::colour")}};
}

RCP<const Vector> diagonalOf(ConstBlockView const& Z, RCP<const Map> const& rows)
{
  const auto diagonal = rcp(new Vector(rows));
  auto const values = diagonal->getLocalViewDevice(Tpetra::Access::OverwriteAll);
  Kokkos::parallel_for(
    "asperity::tnnmg::denseDiagonal", RangePolicy(0, Z.extent(0)),
    KOKKOS_LAMBDA(int i) { values(i, 0) = Z(i, i); });
  return diagonal;
}

HessianView diagonalBlocks(ConstBlockView const& Z, int block_size)
{
  const HessianView blocks("asperity::tnnmg::denseBlocks", Z.extent(0) / block_size, block_size,
                           block_size);
  Kokkos::parallel_for(
    "asperity::tnnmg::denseBlocks", RangePolicy(0, Z.extent(0)), KOKKOS_LAMBDA(int row) {
      const int node = row / block_size;
      for (int l = 0; l < block_size; ++l) {
        blocks(node, row % block_size, l) = Z(row, node * block_size + l);
      }
    });
  return blocks;
}
} // namespace

DenseRateMatrix::DenseRateMatrix(ConstBlockView const& Z, RCP<const Map> const& rows,
                                 int block_size, std::vector<int> const& held)
    : RateMatrix(coupledNodes(Z.extent_int(0), block_size, held), rows, rows, diagonalOf(Z, rows),
                 diagonalBlocks(Z, block_size))
    , Z_(Z)
    , on_host_(toHost(Z))
{
}

void DenseRateMatrix::apply(Vector const& x, Vector& y) const
{
  auto const from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const to = y.getLocalViewHost(Tpetra::Access::OverwriteAll);
  const auto size = static_cast<Eigen::Index>(on_host_.extent(0));
  const Eigen::Map<const Eigen::MatrixXd> Z(on_host_.data(), size, size);
  // Only one triangle is read, since Z is symmetric.
  Eigen::Map<Eigen::VectorXd>(to.data(), size).noalias() =
    Z.selfadjointView<Eigen::Lower>() * Eigen::Map<const Eigen::VectorXd>(from.data(), size);
}

void DenseRateMatrix::sumMagnitudes(Vector const& x, Vector& y) const
{
  auto const from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const to = y.getLocalViewHost(Tpetra::Access::OverwriteAll);
  const std::size_t size = on_host_.extent(0);
  for (std::size_t i = 0; i < size; ++i) {
    to(i, 0) = 0;
    for (std::size_t j = 0; j < size; ++j) {
      to(i, 0) += std::abs(on_host_(i, j) * from(j, 0));
    }
  }
}

int DenseRateMatrix::sweep(NodalProblem const& problem, Vector const&, Vector& v_columns, Vector& r,
                           BlockView const& blocks, BlockView const&) const
{
  auto const& all = nodes().colours.front();
  auto const force = r.getLocalViewDevice(Tpetra::Access::ReadWrite);
  const BlockView r_blocks(force.data(), nodes().numNodes(), nodes().blockSize());
  const int failures = problem.sweep(all, {Z_, r_blocks, nodes().held, curvature()}, blocks);
  scatter(nodes(), all, blocks, v_columns);
  return failures;
}
} // namespace asperity::tnnmg
