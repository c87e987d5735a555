#pragma once

#include "dynamics/coupling/StepUnknown.hpp"
#include "dynamics/fault/Fault.hpp"
#include "dynamics/fault/NormalReaction.hpp"

namespace asperity::dynamics
{
// The normal stress within a step. If it is fixed or lags, the step has its value from the start;
// if it is coupled, it responds to the velocity with the reaction across the fault.
class NormalStressUpdate final : public StepUnknown
{
public:
  // `since_start` has a reaction unless the fault's normal stress is fixed. fault and body must
  // outlive this.
  NormalStressUpdate(Body const& body, Fault const& fault, ReactionSinceStart const& since_start);

  NodeView valuesIn(State const& state) const override { return state.sigma_n; }
  FollowsFrom followsFrom() const override
  {
    return coupled() ? FollowsFrom::fault : FollowsFrom::start;
  }
  std::shared_ptr<const NormalReaction> reaction() const override
  {
    return coupled() ? since_start_.reaction : nullptr;
  }
  // Evaluates sigma_0 at the end of the step and, if the normal stress lags, the load at the
  // beginning.
  void evaluate(double t0, double t1) override;
  // If the normal stress is coupled, raises the guess to the floor.
  void begin(StepStart const& start) override;
  // With the rows of Z across the fault the reaction is r = Z w - b.
  void setRightSide(Vector const& b) override;
  int respond(StepIterate const& step, NodeView const& image) override;
  void limit(NodeView const& sigma_n) const override;
  // The scale of StressScale.hpp for sigma_n at the beginning of the step or, of a fault that may
  // open, for sigma_0 where that is larger.
  ConstNodeView scale() const override { return scale_; }

private:
  ConstNodeView stressOfScale(ConstNodeView const& sigma_n) const;
  bool coupled() const { return change_ == NormalStressChange::coupled; }

  Body const& body_;
  Fault const& fault_;
  NormalStressChange change_;
  ReactionSinceStart since_start_;
  RCP<Vector> load_; // at the beginning, if it lags
  NodeView sigma_0_, right_side_, R_, scale_;
};
} // namespace asperity::dynamics
