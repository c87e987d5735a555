#include "dynamics/rate/OpeningProblem.hpp"

#include <string>

namespace asperity::dynamics
{
namespace
{
// Labels are made once: an iteration launches many kernels.
const std::string label_copy = "asperity::dynamics::copyTangents";
const std::string label_across = "asperity::dynamics::minimiseAcross";
const std::string label_linearise = "asperity::dynamics::lineariseOpening";

// Copies as many components as the smaller of the two blocks has.
void copyTangents(ConstBlockView const& from, BlockView const& to)
{
  const int size = from.extent_int(1) < to.extent_int(1) ? from.extent_int(1) : to.extent_int(1);
  Kokkos::parallel_for(
    label_copy, RangePolicy(0, to.extent_int(0)), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        to(node, k) = from(node, k);
      }
    });
}
} // namespace

OpeningProblem::Memory::Memory(int num_nodes, int num_tangents)
    : v("asperity::dynamics::tangentialVelocity", num_nodes, num_tangents)
    , other("asperity::dynamics::tangentialForce", num_nodes, num_tangents)
    , hessian("asperity::dynamics::tangentialHessian", num_nodes, num_tangents, num_tangents)
{
}

int OpeningProblem::minimise(IndexView const& nodes, ConstNodeView const& curvature,
                             ConstBlockView const& r, BlockView const& v) const
{
  copyTangents(v, memory_.v);
  copyTangents(r, memory_.other);
  const int failures = friction_.minimise(nodes, curvature, memory_.other, memory_.v);
  copyTangents(memory_.v, v);
  auto const lower = bounds_.lower, upper = bounds_.upper;
  const int last = v.extent_int(1) - 1;
  Kokkos::parallel_for(
    label_across, RangePolicy(0, nodes.extent_int(0)), KOKKOS_LAMBDA(int i) {
      const int node = nodes(i);
      // The force is zero where the component is held, whose bounds allow zero.
      v(node, last) = within(lower(node), r(node, last) / curvature(node), upper(node));
    });
  return failures;
}

int OpeningProblem::sweep(IndexView const& nodes, DenseSystem const& system,
                          BlockView const& v) const
{
  auto bounded = system;
  bounded.bounds = bounds_;
  return friction_.sweep(nodes, bounded, v);
}

void OpeningProblem::linearise(ConstBlockView const& v, BlockView const& gradient,
                               HessianView const& hessian, FlagView const& kinked) const
{
  copyTangents(v, memory_.v);
  friction_.linearise(memory_.v, memory_.other, memory_.hessian, kinked);
  auto const of_friction = memory_.hessian;
  auto const force = memory_.other;
  const int size = v.extent_int(1), last = size - 1;
  Kokkos::parallel_for(
    label_linearise, RangePolicy(0, v.extent_int(0)), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        gradient(node, k) = k < last ? force(node, k) : 0;
        for (int l = 0; l < size; ++l) {
          hessian(node, k, l) = k < last && l < last ? of_friction(node, k, l) : 0;
        }
      }
    });
}

double OpeningProblem::slope(ConstBlockView const& v, ConstBlockView const& d, double t) const
{
  copyTangents(v, memory_.v);
  copyTangents(d, memory_.other);
  return friction_.slope(memory_.v, memory_.other, t);
}

tnnmg::EnergyChange OpeningProblem::difference(ConstBlockView const& v,
                                               ConstBlockView const& d) const
{
  copyTangents(v, memory_.v);
  copyTangents(d, memory_.other);
  return friction_.difference(memory_.v, memory_.other);
}

Bounds shut(int num_nodes)
{
  const NodeView zero("asperity::dynamics::shut", num_nodes);
  return {true, zero, zero};
}
} // namespace asperity::dynamics
