#pragma once

#include "friction/Types.hpp"

namespace asperity::friction
{
// The evolution of alpha = ln(theta V* / L) under one law at every node of the fault.
// All views lie on the device and have the shape (num_nodes); V >= 0 is the slip rate in m/s.
class StateKernels
{
public:
  virtual ~StateKernels() = default;

  // alpha1_i := the state after dt >= 0 seconds at the constant slip rate V_i, from alpha0_i. It is
  // exact where the law knows its flow map, and one step of backward Euler elsewhere. alpha1 may be
  // alpha0. Returns the number of nodes where backward Euler failed; there alpha1_i = alpha0_i.
  virtual int flow(ConstNodeView const& V, double dt, ConstNodeView const& alpha0,
                   NodeView const& alpha1) const = 0;

  // alpha_i := the state at which d(alpha)/dt = 0, ln(V* / V_i) for the laws of this package;
  // it is +infinity at V = 0.
  virtual void steadyState(ConstNodeView const& V, NodeView const& alpha) const = 0;
};
} // namespace asperity::friction
