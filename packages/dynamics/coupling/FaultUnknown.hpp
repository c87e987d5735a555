#pragma once

#include "dynamics/State.hpp"
#include "dynamics/coupling/FrictionProblem.hpp"
#include "dynamics/coupling/RateSolver.hpp"

namespace asperity::dynamics
{
// The beginning of a step.
struct StepStart
{
  State const& from;
  double tau;                      // of the step [s]
  ConstBlockView velocity;         // w of gatherSlip in `from` (num_nodes, T) [m/s]
  FrictionProblem const& friction; // with which that velocity was computed
  State const& to;                 // with the first iterates
};

// What the unknowns of a step respond to after each iteration of the rate problem.
struct FaultResponse
{
  State const& from;
  double tau;                      // of the step [s]
  ConstBlockView mean_velocity;    // w of gatherSlip, mean over the step (num_nodes, T) [m/s]
  ConstNodeView slip_rate;         // its magnitude times the slip factor (num_nodes) [m/s]
  RateSolver const& solver;        // which has the velocity
  FrictionProblem const& friction; // with which the velocity was computed
  State const& to;                 // with the present iterates
};

// An unknown of the fixed point of a step beside the velocity: a field of the state at the nodes of
// the fault that the rate problem takes as given and that follows from the velocity.
class FaultUnknown
{
public:
  virtual ~FaultUnknown() = default;

  virtual NodeView const& of(State const& state) const = 0;
  // Prepares for a step. Collective.
  virtual void begin(StepStart const&) {}
  // image(num_nodes): the value that follows from the velocity. Returns how many of this rank's
  // nodes have none. Collective.
  virtual int respond(FaultResponse const& to, NodeView const& image) = 0;
  // Moves values that the acceleration has extrapolated to where the model has a meaning.
  virtual void limit(NodeView const&) const {}
  // (num_nodes): the factor that makes a change of it count like the same change of alpha in
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
      Kokkos::deep_copy(of(to), image);
    }
  }
  // Sets fields of `to` that follow from the unknowns, at the end of the step of tau [s] that has
  // begun and responded last. Steps that are only compared with others end without it.
  virtual void complete(State const& /*from*/, double /*tau*/, State const& /*to*/) {}
};
} // namespace asperity::dynamics
