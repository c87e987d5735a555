#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/RateUpdate.hpp"
#include "dynamics/State.hpp"
#include "dynamics/fault/OpeningForces.hpp"
#include "dynamics/rate/RateSolver.hpp"
#include "portability/DenseSystem.hpp"

#include <optional>

namespace asperity::dynamics
{
// What a fault that may open adds to the equations of a step: forces across it, and the bounds of
// the velocity w across, which is v1 there, since nothing is prescribed.
//
// Without inertia, and with backward Euler, the opening at the end of the step is not negative:
//   g1 = g^ + tau w_K w >= 0
//
// The trapezoidal rule (RateUpdate::allowsContact) has in a0 the force of contact at the beginning,
// which would act once more: nodes would be thrown back. So contact acts at the end alone (Kane,
// Repetto, Ortiz & Marsden 1999): across the fault the other forces at the beginning stand in place
// of M a0. In M (v1 - v0) / tau = mean of the other forces + f the force f of contact is half of
// that in the rate problem. The bound stops a node in the step in which it meets the other side
// (Moreau 1988), which it passes by less than its way in a step; a node that has passed it may go
// no further:
//   w >= min(0, -(v0 + 2 max(g0, 0) / tau))
// Where f > 0, w is this bound, and the change of g, tau (v0 + w) / 2, is not positive: contact
// takes energy in each step or none. Nodes in contact come to rest, and nothing rings, as it does
// with g1 >= 0, where they move to and fro.
class StepOpening
{
public:
  // All but since_start must outlive this; that has a reaction.
  StepOpening(Body const& body, Fault const& fault, RateUpdate const& update,
              ReactionSinceStart const& since_start);

  // Evaluates expressions of the deck for a step from t0 to t1 [s]. Not collective: where one
  // fails, this rank alone throws.
  void evaluate(double t0, double t1);
  // Sets bounds and forces at the beginning of a step of tau [s]. Collective.
  void begin(State const& from, double tau, Vector const& u_hat);
  // b(owned dofs) += the forces across the fault, with the pressure of `to`.
  void add(State const& to, Vector& b);

  Bounds const& bounds() const { return bounds_; }
  // R(num_nodes) := what makes the stress of contact zero, where the answer is within its bounds:
  // contact is then absent, and what the reaction has there is the error of the answer.
  void clearWhereOpen(RateSolver const& solver, NodeView const& R) const;
  // (num_nodes) [N], c, if the rate problem has twice the force of contact, otherwise without
  // entries: the reaction r = Z w - b without these forces means a force across of (r + c) / 2.
  ConstNodeView carried() const { return carried_; }

private:
  Body const& body_;
  fem::FaultSurface const& surface_;
  RateUpdate const& update_;
  OpeningForces at_end_;
  NodeView lower_, upper_; // of bounds_
  Bounds bounds_;
  BlockView w_; // (num_nodes, T + 1), of the answer
  // For the trapezoidal rule with inertia:
  std::optional<OpeningForces> at_start_;
  RCP<Vector> load_, start_; // (owned dofs) loads, and all forces but M a0, at the beginning
  NodeView before_, carried_;
};
} // namespace asperity::dynamics
