#pragma once

#include "portability/Views.hpp"

namespace asperity::friction
{
using ParameterView = Kokkos::View<const double**, MemorySpace>; // (num_parameters, num_nodes)

// The data of the fault's nodes that friction depends on and that do not change in a run. The views
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

// mu and its first two derivatives with respect to ln V, all dimensionless.
struct Response
{
  double mu;
  double first;
  double second;
};

// The arguments of friction in addition to the velocity.
struct StateAndStress
{
  ConstNodeView alpha;   // ln(theta V* / L), or what the law declares instead (LawProperties.hpp)
  ConstNodeView sigma_n; // normal stress, compression, >= 0, Pa
  // (num_nodes, T), m/s, added to the unknowns to give the velocity. At a node with one free and
  // one prescribed component it is the prescribed velocity in the latter, whose unknown is zero;
  // all other entries are zero. A view without entries means zero everywhere.
  ConstBlockView prescribed = {};
};
} // namespace asperity::friction
