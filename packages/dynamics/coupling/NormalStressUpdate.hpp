#pragma once

#include "dynamics/Fault.hpp"
#include "dynamics/NormalReaction.hpp"
#include "dynamics/State.hpp"
#include "dynamics/coupling/RateSolver.hpp"

namespace asperity::dynamics
{
// The normal stress within a step: its value at first and, if it is coupled, its response to the
// velocity. The functions are called in the order of their declarations.
class NormalStressUpdate
{
public:
  // `since_start` has a reaction unless the fault's normal stress is fixed. fault and body must
  // outlive this.
  NormalStressUpdate(Body const& body, Fault const& fault, ReactionSinceStart const& since_start);

  bool coupled() const { return change_ == NormalStressChange::coupled; }
  bool lagged() const { return change_ == NormalStressChange::lagged; }

  // Evaluates sigma_0 at the end t1 [s] of the step and, if the normal stress lags, the load at the
  // beginning t0 [s]. Not collective: where an expression fails, this rank alone throws.
  void evaluate(double t0, double t1);
  // Sets sigma_n(num_nodes) for the step if it lags. If it is coupled, its content is the first
  // guess, which is raised to the floor. Collective.
  void begin(State const& from, friction::NodeView const& sigma_n);
  // Keeps the rows across the fault of a step's b = l + M a^ - K u^ - Z v_D, which a rate problem
  // leaves out. With the same rows of Z the reaction is r = Z w - b.
  void takeRightSide(Vector const& b);
  // sigma_n(num_nodes) that follows from the solver's last answer. Collective.
  void respond(RateSolver const& solver, friction::NodeView const& sigma_n);

  // The factor that makes a change of sigma_n count like one of alpha: a relative change eps of
  // sigma_n changes the strength f sigma_n of the fault as much as a change f / b eps of alpha, and
  // f / b is about 50. So it is 50 / sigma_n at the beginning of the step; a sigma_n below 1 % of
  // the largest counts as that 1 %.
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
