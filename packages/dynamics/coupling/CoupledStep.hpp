#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/State.hpp"
#include "dynamics/coupling/CouplingSettings.hpp"
#include "dynamics/coupling/SolveCount.hpp"
#include "dynamics/coupling/StepEquations.hpp"
#include "dynamics/coupling/StepUnknowns.hpp"
#include "dynamics/fault/Fault.hpp"
#include "dynamics/rate/OpeningProblem.hpp"
#include "dynamics/rate/StepSolvers.hpp"

#include <optional>

namespace asperity::dynamics
{
enum class StepStatus
{
  solved,
  rate_problem_failed,
  state_failed,
  fixed_point_failed
};

// Names a step that has been solved at the fault alone. CoupledStep::complete takes it until
// another step begins.
struct PendingStep
{
  int level;
  std::int64_t number; // of all steps that the CoupledStep has begun
};

struct StepSettings
{
  RateUpdate update;
  DyadicTime clock;
  CouplingSettings coupling;
  RateSolverSettings solver;
  std::size_t solver_memory; // bytes for the solvers of different step sizes, see StepSolvers
};

struct CoupledResult
{
  StepStatus status = StepStatus::solved;
  int iterations = 0;              // of the fixed point
  std::optional<PendingStep> rest; // of a solved step
  bool solved() const { return status == StepStatus::solved; }
};

// One time step: the fixed point alpha -> rate problem -> V -> state flow -> alpha (Pipping 2014,
// problem 4.3), accelerated. While alpha still changes, each rate problem gets one iteration of
// TNNMG only. The state evolves with the mean slip rate of the step,
// V = slip_factor |u1 - u0|_t / tau, which is of second order with every scheme and damped wherever
// the scheme damps u; for Newmark with beta = 1/4 it is that of thesis eq. (25) with lambda = 1/2.
// Under back slip V = |slip_factor (u1 - u0)_t / tau + Vp|.
//
// What else each rate problem takes as given is an unknown of the fixed point in addition to alpha:
// a normal stress that is coupled to the body, what processes on the fault add, and the inelastic
// strain of rock that yields (StepUnknown). Each rate problem is convex, since all of them are
// fixed in it.
class CoupledStep
{
public:
  // since_start: the reaction that the normal stress follows, unless it is fixed; that of a fault
  // that may open follows it at once. body and fault must outlive the step.
  CoupledStep(Body const& body, Fault const& fault, StepSettings const& settings,
              ReactionSinceStart const& since_start = {});
  // The same with these unknowns in place of unknownsOf.
  CoupledStep(Body const& body, Fault const& fault, StepSettings const& settings,
              StepUnknownList unknowns, ReactionSinceStart const& since_start = {});

  // The unknowns of a body and its fault, see the constructors: alpha, the normal stress, those of
  // processes, and the inelastic strain.
  static StepUnknownList unknownsOf(Body const& body, Fault const& fault,
                                    ReactionSinceStart const& since_start);

  DyadicTime const& clock() const { return settings_.clock; }
  fem::FaultSurface const& surface() const { return fault_.surface(); }
  Body const& body() const { return body_; }
  Fault const& fault() const { return fault_; }
  RateUpdate const& update() const { return settings_.update; }
  StepSolvers const& solvers() const { return solvers_; }
  // The right side of the last rate problem: loads, and terms from the past and from prescribed
  // velocities.
  RCP<Vector> const& lastRightSide() const { return equations_.rightSide(); }

  // Makes a step of the given level from `from` to `to`, which must have the shapes of `from`. On
  // entry `to` holds a guess of the fields that are guessed. If the step fails, only the unknowns
  // of the fault in `to`, the last iterates, may be used, in messages. Collective.
  CoupledResult solve(State const& from, int level, State& to, SolveCount& count);

  // The same for the fault alone: its unknowns and v there; v elsewhere is a guess, and u, a and
  // jerk are not set. This is enough for a step that is only compared with others, and saves half
  // of the elimination with the direct correction.
  CoupledResult solveAtFault(State const& from, int level, State& to, SolveCount& count);
  // Computes the rest of the state `to` at the end of that step from `from`: v off the fault, and
  // the other fields of the body. No other step may have begun since. Collective.
  void complete(PendingStep const& step, State const& from, State& to);

  // The error of a step that ends in a, if b is its exact end, between steps: the largest of the
  // unknowns. Collective.
  double distance(State const& a, State const& b, Norm norm) const
  {
    return unknowns_.distance(a, b, norm);
  }

private:
  // How far a rate problem is solved before the unknowns respond to it.
  enum class Effort
  {
    one_iteration, // of TNNMG
    solution       // to its own tolerance
  };
  struct Response
  {
    StepStatus status = StepStatus::solved;
    bool rate_converged = false;
    double change = 0;         // of the unknowns, between the iterates and their images
    ConstNodeView alpha;       // with which the rate problem was solved; until the next response
    bool has_velocity = false; // whether `w` has the velocity of the whole body
  };

  void beginUnknowns(State const& from, double tau, State const& to);
  CoupledResult iterate(State const& from, double tau, RateSolver& solver, Vector& w, State& to,
                        SolveCount& count);
  Response respond(Effort effort, State const& from, double tau, RateSolver& solver, Vector& w,
                   State& to, SolveCount& count);
  tnnmg::TnnmgResult workOn(Effort effort, FrictionProblem const& friction,
                            RateSolver& solver) const;
  void meanSlipRate(RateSolver const& solver, BlockView const& mean, NodeView const& V) const;

  Body const& body_;
  Fault const& fault_;
  StepSettings settings_;
  StepUnknowns unknowns_;
  FrictionInput given_;
  StepSolvers solvers_;
  StepEquations equations_;
  std::int64_t num_begun_ = 0; // steps, to tell which one may be completed
  RCP<Vector> w_;              // (owned dofs), of solveAtFault
  // At the nodes of the fault: w of gatherSlip at the beginning and its mean (num_nodes, T), and
  // the slip rate (num_nodes).
  BlockView start_velocity_, mean_velocity_;
  NodeView slip_rate_;
  std::optional<OpeningProblem::Memory> memory_; // if the fault may open
};
} // namespace asperity::dynamics
