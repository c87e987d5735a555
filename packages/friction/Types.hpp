#pragma once

#include "portability/Views.hpp"

namespace asperity::friction
{
using ParameterView = Kokkos::View<const double**, MemorySpace>; // (num_parameters, num_nodes)

// What friction needs to know about the fault's nodes and what does not change in a run. The views
// are shared with the caller; the parameters are read once, when the kernels are made.
struct FaultView
{
  ConstNodeView weight;   // integral of the node's basis function over the fault, m^(d-1)
  ConstNodeView cohesion; // >= 0, Pa

  // Slip rate V = slip_factor |v_t|: 1 against a rigid foundation, 2 where the body is one half of
  // an antisymmetric whole. A view without entries means 1 everywhere.
  ConstNodeView slip_factor;

  ParameterView parameters; // rows in the order of the law's table
};

// mu and its first two derivatives with respect to log V, all without a dimension.
struct Response
{
  double mu;
  double first;
  double second;
};

// What else than the velocity friction is evaluated at: an argument of each call.
struct StateAndStress
{
  ConstNodeView alpha;   // ln(theta V* / L)
  ConstNodeView sigma_n; // normal stress, compression, >= 0, Pa
  // (num_nodes, T), m/s: what is added to the velocity of each node. It is zero in components that
  // are free, and is not in those whose velocity is prescribed beside a free one, where the unknown
  // is zero. A view without entries means zero everywhere.
  ConstBlockView prescribed = {};
};
} // namespace asperity::friction
