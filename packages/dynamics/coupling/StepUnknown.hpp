#pragma once

#include "dynamics/State.hpp"
#include "dynamics/fault/Norm.hpp"
#include "dynamics/fault/NormalReaction.hpp"
#include "dynamics/rate/FrictionProblem.hpp"
#include "dynamics/rate/RateSolver.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace asperity::dynamics
{
class StepOpening;

// The beginning of a step.
struct StepStart
{
  State const& from;
  double t;                        // at the beginning [s]
  double tau;                      // of the step [s]
  ConstBlockView velocity;         // w of gatherSlip in `from` (num_nodes, T) [m/s]
  FrictionProblem const& friction; // with which that velocity was computed
  State const& to;                 // with the first iterates
};

// What the unknowns of a step respond to after an iteration of the rate problem.
struct StepIterate
{
  State const& from;
  double tau;                           // of the step [s]
  ConstBlockView mean_velocity;         // w of gatherSlip, mean over the step (num_nodes, T) [m/s]
  ConstNodeView slip_rate;              // its magnitude times the slip factor (num_nodes) [m/s]
  RateSolver const& solver;             // which has the velocity
  FrictionProblem const& friction;      // with which the velocity was computed
  State const& to;                      // with the present iterates
  Vector const* u_in_body = nullptr;    // (owned dofs) at the end of the step [m], see FollowsFrom
  StepOpening const* opening = nullptr; // unless the fault cannot open
};

// What an unknown of a step follows from, and so what its image costs.
enum class FollowsFrom
{
  // What is known when the step begins: the value that begin() sets is final.
  start,
  // The motion of the fault: images are computed after each iteration of the rate problem.
  fault,
  // The motion of the whole body, whose computation costs as much as a linear solve. So images are
  // computed in two cases alone: what follows from the fault has converged; or it changes less than
  // this unknown did the last time, and this unknown is expected to change further.
  body
};

// Where the values of an unknown are, and how they are measured.
class UnknownSpace
{
public:
  virtual ~UnknownSpace() = default;
  // (num_values): of this rank's values, of which each counts on one rank.
  virtual ConstNodeView weights() const = 0;
  virtual RCP<const Communicator> communicator() const = 0;
  // The error of values if `exact` is right, as a change of alpha that matters as much. Collective.
  virtual double distance(ConstNodeView const& values, ConstNodeView const& exact,
                          Norm norm) const = 0;
};

// An unknown of the fixed point of a step, in addition to the velocity: a field of the state that
// the rate problem takes as given and that follows from the velocity. What it remembers from one
// step to the next is in fields of the state, which checkpoints have.
class StepUnknown
{
public:
  virtual ~StepUnknown() = default;

  virtual NodeView valuesIn(State const& state) const = 0;
  virtual FollowsFrom followsFrom() const { return FollowsFrom::fault; }
  // Null: the nodes of the fault. Otherwise it lives as long as the unknown.
  virtual UnknownSpace const* space() const { return nullptr; }

  // Evaluates expressions of the deck for a step from t0 to t1 [s]. Not collective: where one
  // fails, this rank alone throws.
  virtual void evaluate(double t0, double t1) { static_cast<void>(t0), static_cast<void>(t1); }
  // Prepares for a step. Throws SolveError if that fails. Collective.
  virtual void begin(StepStart const&) {}

  // Whether it adds forces to the right side of the rate problem.
  virtual bool addsForces() const { return false; }
  // b(owned dofs) += the forces of the iterate in `to` [N].
  virtual void addForces(State const& to, Vector& b) const
  {
    static_cast<void>(to), static_cast<void>(b);
  }
  // b: the right side of the rate problems to come, l + M a^ - K u^ - Z v_D and all added forces,
  // with the rows of held dofs, which rate problems leave out.
  virtual void setRightSide(Vector const& b) { static_cast<void>(b); }
  // The reaction that it needs from the solver, see RateSolver::reactions; null if none.
  virtual std::shared_ptr<const NormalReaction> reaction() const { return nullptr; }

  // image(num_values): the value that follows from the motion. Returns for how many of this rank's
  // values there is none. Collective.
  virtual int respond(StepIterate const& step, NodeView const& image) = 0;
  // Moves values that the acceleration has extrapolated into the range in which the model has a
  // meaning.
  virtual void limit(NodeView const&) const {}
  // (num_values): the factor that makes a change of it count like the same change of alpha in
  // tolerances and in the acceleration; a view without entries means 1.
  virtual ConstNodeView scale() const { return {}; }
  // Whether the state at the end of the step has the last image, or the value with which the rate
  // problem was solved. An unknown that follows from its own value at the beginning of the step
  // needs its image: a change below the tolerance would be lost in every step.
  virtual bool endsWithImage() const { return false; }
  // Ends the fixed point: sets the field in `to`, which has the last iterate, to its final value.
  virtual void finish(ConstNodeView const& image, State const& to) const
  {
    if (endsWithImage()) {
      Kokkos::deep_copy(valuesIn(to), image);
    }
  }
  // Sets fields of `to` that follow from the unknowns, at the end of the step of tau [s] that has
  // begun and responded last. Steps that are only compared with others end without it.
  virtual void complete(State const& /*from*/, double /*tau*/, State const& /*to*/) {}
};
using StepUnknownList = std::vector<std::shared_ptr<StepUnknown>>;

// An added field of the fault that is known when a step begins.
class KnownField final : public StepUnknown
{
public:
  // set: its values(num_nodes) at the end of a step. Collective.
  using Set = std::function<void(StepStart const&, NodeView const& values)>;
  KnownField(std::string name, Set set) : name_(std::move(name)), set_(std::move(set)) {}

  NodeView valuesIn(State const& state) const override { return state.at(name_); }
  FollowsFrom followsFrom() const override { return FollowsFrom::start; }
  void begin(StepStart const& start) override { set_(start, valuesIn(start.to)); }
  int respond(StepIterate const&, NodeView const&) override { return 0; }

private:
  std::string name_;
  Set set_;
};
} // namespace asperity::dynamics
