#pragma once

#include "portability/Spaces.hpp"

#include <Kokkos_Core.hpp>

// Views over the nodes of the fault. Every array is indexed by the node's local number.
namespace asperity::friction
{
using asperity::ExecutionSpace;
using asperity::MemorySpace;

using NodeView = Kokkos::View<double*, MemorySpace>; // (num_nodes)
using ConstNodeView = Kokkos::View<const double*, MemorySpace>;
using IndexView = Kokkos::View<const int*, MemorySpace>;         // (any number of nodes)
using FlagView = Kokkos::View<int*, MemorySpace>;                // (num_nodes), 0 or 1
using ParameterView = Kokkos::View<const double**, MemorySpace>; // (num_parameters, num_nodes)

// Tangential vectors: T = 1 component in two dimensions and antiplane, 2 in three.
using BlockView = Kokkos::View<double**, Kokkos::LayoutRight, MemorySpace>; // (num_nodes, T)
using ConstBlockView = Kokkos::View<const double**, Kokkos::LayoutRight, MemorySpace>;
using HessianView = Kokkos::View<double***, Kokkos::LayoutRight, MemorySpace>; // (num_nodes, T, T)

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

// The linear part of a rate problem in which each node is coupled with each: Z, and the force
// r = b - Z v of the present v. The rows and columns of Z are the T components of node 0, then
// those of node 1, and so on.
struct CoupledNodes
{
  ConstBlockView Z;        // (num_nodes T, num_nodes T), symmetric, N s/m
  BlockView r;             // (num_nodes, T), N
  IndexView held;          // (num_nodes T): 1 where the force does not count
  ConstNodeView curvature; // (num_nodes), > 0, N s/m
};

// What friction is evaluated at besides the velocity: an argument of each call.
struct StateAndStress
{
  ConstNodeView alpha;   // ln(theta V* / L)
  ConstNodeView sigma_n; // normal stress, compression, >= 0, Pa
};
} // namespace asperity::friction
