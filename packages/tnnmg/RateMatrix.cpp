#include "tnnmg/RateMatrix.hpp"

#include "portability/Renamed.hpp"

#include <Tpetra_Map.hpp>

#include <string>
#include <utility>

namespace asperity::tnnmg
{
namespace
{
// Labels are made once: a sweep launches hundreds of kernels.
const std::string label_gather = "asperity::tnnmg::gather";
const std::string label_scatter = "asperity::tnnmg::scatter";

NodeView nodalCurvature(HessianView const& blocks, NonlinearNodes const& nodes)
{
  NodeView curvature("asperity::tnnmg::curvature", nodes.numNodes());
  auto const dofs = nodes.dofs;
  auto const held = nodes.held;
  const int size = nodes.blockSize();
  Kokkos::parallel_for(
    "asperity::tnnmg::nodalCurvature", RangePolicy(0, nodes.numNodes()), KOKKOS_LAMBDA(int node) {
      double block[3][3] = {};
      for (int k = 0; k < size; ++k) {
        for (int l = 0; l < size; ++l) {
          const bool free = !held(dofs(node, k)) && !held(dofs(node, l));
          block[k][l] = free ? blocks(node, k, l) : 0;
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
} // namespace

RateMatrix::RateMatrix(NonlinearNodes nodes, RCP<const Map> rows, RCP<const Map> columns,
                       RCP<const Vector> diagonal, HessianView const& blocks)
    : nodes_(std::move(nodes))
    , rows_(std::move(rows))
    , columns_(std::move(columns))
    , diagonal_(std::move(diagonal))
    , curvature_(nodalCurvature(blocks, nodes_))
{
}

void RateMatrix::residual(Vector const& b, Vector const& v, Vector& r) const
{
  apply(v, r);
  r.update(1, b, -1);
}

void gather(NodeDofView const& dofs, Vector const& v, BlockView const& blocks)
{
  auto const values = v.getLocalViewDevice(Tpetra::Access::ReadOnly);
  Kokkos::parallel_for(
    label_gather, RangePolicy(0, dofs.extent(0)), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < dofs.extent_int(1); ++k) {
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
    label_scatter, RangePolicy(0, which.extent(0)), KOKKOS_LAMBDA(int i) {
      const int node = which(i);
      for (int k = 0; k < size; ++k) {
        values(dofs(node, k), 0) = blocks(node, k);
      }
    });
}
} // namespace asperity::tnnmg
