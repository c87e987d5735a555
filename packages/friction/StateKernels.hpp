#pragma once

#include "friction/Types.hpp"

namespace asperity::friction
{
// The evolution of alpha under one law at every node of the fault. alpha is ln(theta V* / L) unless
// the law declares another state variable (LawProperties.hpp).
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

  // alpha_i := the state at which d(alpha)/dt = 0 at the slip rate V_i: ln(V* / V_i) under Ageing
  // and Slip; the state in which friction is the law's steady friction under Strong Rate Weakening,
  // Flash Heating and Tabulated; 0 under None. It is +infinity under Slip Weakening, which has no
  // steady state, and at V = 0 under all laws of this package but None.
  virtual void steadyState(ConstNodeView const& V, NodeView const& alpha) const = 0;
};
} // namespace asperity::friction
