#pragma once

#include "friction/Length.hpp"
#include "friction/Parameter.hpp"
#include "friction/Types.hpp"
#include "friction/detail/NodePotential.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace asperity::friction::detail
{
// A view that does not count references; another view has to keep its memory alive.
template <class View>
using Unmanaged = Kokkos::View<typename View::data_type, typename View::array_layout,
                               typename View::device_type, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

template <class Law>
using LawView = Kokkos::View<const Law*, MemorySpace>;

// The parameters at one node.
struct ParameterColumn
{
  ParameterView values;
  int node;

  KOKKOS_INLINE_FUNCTION double operator()(std::size_t row) const { return values(row, node); }
};

// The laws at all nodes, read from the columns of `parameters` once: laws(num_nodes).
// Throws std::invalid_argument if the number of rows is not that of the law's table.
template <class Law>
LawView<Law> loadLaws(ParameterView const& parameters)
{
  constexpr std::size_t expected = num_parameters<Law>;
  if (parameters.extent(0) != expected) {
    throw std::invalid_argument(std::string("asperity::friction: ") + Law::name + " has " +
                                std::to_string(expected) + " parameters, but the view has " +
                                std::to_string(parameters.extent(0)) + " rows.");
  }
  const Kokkos::View<Law*, MemorySpace> laws(
    Kokkos::view_alloc("asperity::friction::laws", Kokkos::WithoutInitializing),
    parameters.extent(1));
  Kokkos::parallel_for(
    "asperity::friction::loadLaws", RangePolicy(0, laws.extent(0)), KOKKOS_LAMBDA(int node) {
      laws(node) = loadLaw<Law>(ParameterColumn{parameters, node});
    });
  ExecutionSpace().fence();
  return laws;
}

// psi at the nodes, for given states and stresses. The kernels copy it to the device.
template <class Law>
struct NodePotentials
{
  Unmanaged<LawView<Law>> laws;
  Unmanaged<ConstNodeView> weight;
  Unmanaged<ConstNodeView> cohesion;
  Unmanaged<ConstNodeView> slip_factor;
  Unmanaged<ConstNodeView> alpha = {};       // set by at()
  Unmanaged<ConstNodeView> sigma_n = {};     // set by at()
  Unmanaged<ConstBlockView> prescribed = {}; // set by at(); perhaps without entries

  NodePotentials at(StateAndStress const& given) const
  {
    return {laws, weight, cohesion, slip_factor, given.alpha, given.sigma_n, given.prescribed};
  }

  KOKKOS_INLINE_FUNCTION NodePotential<typename Law::Curve> operator()(int node) const
  {
    return {weight(node), sigma_n(node), cohesion(node), slip_factor(node),
            laws(node).at(alpha(node))};
  }

  // The velocity that friction depends on: rate[T] = v + prescribed, where v has the unknowns.
  template <int T>
  KOKKOS_INLINE_FUNCTION void loadRate(int node, double const* v, double (&rate)[T]) const
  {
    const bool adds = prescribed.extent(0) > 0;
    for (int j = 0; j < T; ++j) {
      rate[j] = adds ? v[j] + prescribed(node, j) : v[j];
    }
  }

  // The length of the prescribed part of that velocity.
  template <int T>
  KOKKOS_INLINE_FUNCTION double prescribedRate(int node) const
  {
    if (prescribed.extent(0) == 0) {
      return 0;
    }
    double part[T];
    for (int j = 0; j < T; ++j) {
      part[j] = prescribed(node, j);
    }
    return length(part);
  }

  int size() const { return static_cast<int>(laws.extent(0)); }
};

// Points into `laws` and `fault`, at no state yet. A slip factor that is left out becomes 1 in
// `fault`. Throws std::invalid_argument if the views are for different numbers of nodes.
template <class Law>
NodePotentials<Law> makeNodePotentials(LawView<Law> const& laws, FaultView& fault)
{
  const std::size_t num_nodes = laws.extent(0);
  if (fault.slip_factor.extent(0) == 0) {
    const NodeView ones("asperity::friction::slip_factor", num_nodes);
    Kokkos::deep_copy(ones, 1.0);
    fault.slip_factor = ones;
  }
  for (auto const& view : {fault.weight, fault.cohesion, fault.slip_factor}) {
    if (view.extent(0) != num_nodes) {
      throw std::invalid_argument(std::string("asperity::friction: ") + Law::name + ": " +
                                  view.label() + " has " + std::to_string(view.extent(0)) +
                                  " entries, but the fault has " + std::to_string(num_nodes) +
                                  " nodes.");
    }
  }
  return {laws, fault.weight, fault.cohesion, fault.slip_factor};
}
} // namespace asperity::friction::detail
