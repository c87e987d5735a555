#include "tnnmg/BoundedNodes.hpp"

#include "portability/Renamed.hpp"

#include <limits>

namespace asperity::tnnmg::detail
{
BoundedNodes::BoundedNodes(NonlinearNodes const& nodes, Bounds const& bounds)
    : nodes_(nodes)
    , bounds_(bounds)
    , fixed_("asperity::tnnmg::fixed", nodes.numNodes(), nodes.blockSize())
{
}

void BoundedNodes::moveIntoBounds(BlockView const& v, Vector& x) const
{
  auto const values = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const dofs = nodes_.dofs;
  auto const lower = bounds_.lower, upper = bounds_.upper;
  const int last = nodes_.blockSize() - 1;
  Kokkos::parallel_for(
    "asperity::tnnmg::moveIntoBounds", RangePolicy(0, nodes_.numNodes()), KOKKOS_LAMBDA(int node) {
      const double value = v(node, last);
      const double rounding = 4 * std::numeric_limits<double>::epsilon() * math::fabs(value);
      const double moved = value <= lower(node) + rounding   ? lower(node)
                           : value >= upper(node) - rounding ? upper(node)
                                                             : value;
      v(node, last) = moved;
      values(dofs(node, last), 0) = moved;
    });
}

void BoundedNodes::truncate(TnnmgBlocks const& blocks, ConstNodeView const& curvature,
                            double stiff) const
{
  auto const flags = blocks.truncated;
  auto const H = blocks.hessian;
  auto const v = blocks.v;
  auto const fixed = fixed_;
  auto const dofs = nodes_.dofs;
  auto const held = nodes_.held;
  auto const lower = bounds_.lower, upper = bounds_.upper;
  const int size = nodes_.blockSize(), last = size - 1;
  Kokkos::parallel_for(
    "asperity::tnnmg::truncateComponents", RangePolicy(0, nodes_.numNodes()),
    KOKKOS_LAMBDA(int node) {
      bool soft = !flags(node); // which has the kinks so far
      for (int k = 0; k < last; ++k) {
        soft = soft && (held(dofs(node, k)) || H(node, k, k) <= stiff * curvature(node));
      }
      const bool at_bound = v(node, last) <= lower(node) || v(node, last) >= upper(node);
      bool all_fixed = true;
      for (int k = 0; k < size; ++k) {
        fixed(node, k) = held(dofs(node, k)) || (k < last ? !soft : at_bound);
        all_fixed = all_fixed && fixed(node, k);
      }
      for (int k = 0; k < size; ++k) {
        for (int l = 0; l < size; ++l) {
          H(node, k, l) = fixed(node, k) || fixed(node, l) ? 0 : H(node, k, l);
        }
        if (fixed(node, k) && !held(dofs(node, k))) {
          H(node, k, k) = stiff * curvature(node);
        }
      }
      flags(node) = all_fixed;
    });
}

void BoundedNodes::clearFixed(Vector& x) const
{
  auto const values = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const fixed = fixed_;
  auto const dofs = nodes_.dofs;
  const int size = nodes_.blockSize();
  Kokkos::parallel_for(
    "asperity::tnnmg::clearFixed", RangePolicy(0, nodes_.numNodes()), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        auto& value = values(dofs(node, k), 0);
        value = fixed(node, k) ? 0 : value;
      }
    });
}

void BoundedNodes::project(ConstBlockView const& v, Vector& c) const
{
  auto const values = c.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const dofs = nodes_.dofs;
  auto const lower = bounds_.lower, upper = bounds_.upper;
  const int last = nodes_.blockSize() - 1;
  Kokkos::parallel_for(
    "asperity::tnnmg::projectOntoBounds", RangePolicy(0, nodes_.numNodes()),
    KOKKOS_LAMBDA(int node) {
      auto& value = values(dofs(node, last), 0);
      value = within(lower(node) - v(node, last), value, upper(node) - v(node, last));
    });
}

double BoundedNodes::largestStep(ConstBlockView const& v, Vector const& c) const
{
  auto const values = c.getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const dofs = nodes_.dofs;
  auto const lower = bounds_.lower, upper = bounds_.upper;
  const int last = nodes_.blockSize() - 1;
  double result = 1;
  Kokkos::parallel_reduce(
    "asperity::tnnmg::largestStep", RangePolicy(0, nodes_.numNodes()),
    KOKKOS_LAMBDA(int node, double& least) {
      const double change = values(dofs(node, last), 0);
      const double room = (change < 0 ? lower(node) : upper(node)) - v(node, last);
      if (change != 0 && room / change < least) {
        least = room / change;
      }
    },
    Kokkos::Min<double>(result));
  return result < 1 ? result : 1; // a rank may have no nodes
}
} // namespace asperity::tnnmg::detail
