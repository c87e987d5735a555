#pragma once

#include "dynamics/Fault.hpp"
#include "dynamics/NormalReaction.hpp"
#include "dynamics/State.hpp"
#include "dynamics/coupling/RateSolver.hpp"

namespace asperity::dynamics
{
// The normal stress within a step: what it is to begin with, and its answer to a velocity where it
// is coupled. Calls in the order of the declarations.
class NormalStressUpdate
{
public:
  // `since_start` has a reaction unless the fault's normal stress is fixed. fault and body must
  // outlive this.
  NormalStressUpdate(Body const& body, Fault const& fault, ReactionSinceStart const& since_start);

  bool coupled() const { return change_ == NormalStressChange::coupled; }
  bool lagged() const { return change_ == NormalStressChange::lagged; }

  // sigma_0 at the step's end t1 [s] and, if it lags, the load at its beginning t0 [s]. On this
  // rank alone; an error of an expression is thrown here.
  void evaluate(double t0, double t1);
  // sigma_n(num_nodes) for the step; where it is coupled its content is the first guess.
  void begin(State const& from, friction::NodeView const& sigma_n);
  // Of a step's b = l + M a^ - K u^ - Z v_D the rows across the fault, which a rate problem leaves
  // out: with Z of all dofs the reaction is r = Z w - b.
  void takeRightSide(Vector const& b);
  // sigma_n(num_nodes) that follows from the solver's last answer. All ranks together.
  void respond(RateSolver const& solver, friction::NodeView const& sigma_n);

  // sigma_n in units that make a change count like one of alpha: a relative change of eps changes
  // the strength f sigma_n of the fault as much as a change f / b eps of alpha, and f / b is about
  // 50. Relative to sigma_n at the step's beginning, but where that is far below the largest.
  friction::ConstNodeView const& perPascal() const { return per_pascal_; } // (num_nodes) [1/Pa]

private:
  Body const& body_;
  Fault const& fault_;
  NormalStressChange change_;
  ReactionSinceStart since_start_;
  RCP<Vector> load_; // at the beginning, if it lags
  std::vector<double> right_side_;
  friction::NodeView sigma_0_, R_, scale_;
  friction::ConstNodeView per_pascal_;
};
} // namespace asperity::dynamics
