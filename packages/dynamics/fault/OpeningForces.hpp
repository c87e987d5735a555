#pragma once

#include "dynamics/State.hpp"
#include "dynamics/fault/Fault.hpp"
#include "dynamics/fault/NormalReaction.hpp"

namespace asperity::dynamics
{
// What acts across a fault that may open in addition to the forces of the body. The stress of the
// body counts from the start of the run: the normal stress sigma_0 in which that started presses
// the two sides together. The pressure p of fluids in the fault parts them. At node i they press
// with the stress
//   sigma_0_i - R_i(start) - p_i
// so that where the fault is open R - R(start) + sigma_0 = p, and where it is shut the difference
// of both is the stress of contact, which is not negative.
class OpeningForces
{
public:
  // since_start has a reaction, and the fault may open. fault must outlive this.
  OpeningForces(Fault const& fault, ReactionSinceStart const& since_start);

  // Evaluates sigma_0 at t [s]. Not collective: where an expression fails, this rank alone throws.
  void evaluate(double t);
  // b(owned dofs) += these forces [N] at the nodes that may open, with the pressure of the state.
  void add(State const& state, Vector& b) const;
  // The stress (num_nodes) [Pa] of the forces that were added last.
  ConstNodeView stress() const { return stress_; }

private:
  Fault const& fault_;
  ReactionSinceStart since_start_;
  NodeView sigma_0_, pressure_, stress_; // (num_nodes)
};

// The opening of the fault (num_nodes) [m], or its rate [m/s], for u or v(owned dofs): zero at
// nodes that cannot open.
NodeView openingOf(fem::FaultSurface const& surface, Vector const& u);
} // namespace asperity::dynamics
