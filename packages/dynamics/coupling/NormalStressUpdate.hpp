#pragma once

#include "dynamics/coupling/FaultUnknown.hpp"
#include "dynamics/fault/Fault.hpp"
#include "dynamics/fault/NormalReaction.hpp"

namespace asperity::dynamics
{
// The normal stress within a step. If it is fixed or lags, the step has its value from the start;
// if it is coupled, it is an unknown that responds to the velocity with the reaction across the
// fault. evaluate(), begin() and setRightSide() open a step.
class NormalStressUpdate final : public FaultUnknown
{
public:
  // `since_start` has a reaction unless the fault's normal stress is fixed. fault and body must
  // outlive this.
  NormalStressUpdate(Body const& body, Fault const& fault, ReactionSinceStart const& since_start);

  bool coupled() const { return change_ == NormalStressChange::coupled; }

  // Evaluates sigma_0 at the end t1 [s] of the step and, if the normal stress lags, the load at the
  // beginning t0 [s]. Not collective: where an expression fails, this rank alone throws.
  void evaluate(double t0, double t1);
  // Sets the normal stress of `to`; if it is coupled, raises the guess there to the floor.
  // Collective.
  void begin(State const& from, State& to);
  // b is the right side l + M a^ - K u^ - Z v_D of a rate problem with the rows across the fault,
  // which it leaves out: with the same rows of Z the reaction is r = Z w - b.
  void setRightSide(Vector const& b);

  NodeView const& of(State const& state) const override { return state.sigma_n; }
  int respond(FaultResponse const& to, NodeView const& image) override;
  void limit(NodeView const& sigma_n) const override;
  // That of StressScale.hpp, of sigma_n at the beginning of the step.
  ConstNodeView scale() const override { return scale_; }

private:
  Body const& body_;
  Fault const& fault_;
  NormalStressChange change_;
  ReactionSinceStart since_start_;
  RCP<Vector> load_; // at the beginning, if it lags
  NodeView sigma_0_, right_side_, R_, scale_;
};
} // namespace asperity::dynamics
