#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/State.hpp"
#include "dynamics/coupling/StepSolvers.hpp"
#include "dynamics/coupling/StepUnknowns.hpp"
#include "dynamics/fault/Fault.hpp"

#include <array>
#include <optional>

namespace asperity::dynamics
{
struct CouplingSettings
{
  double tolerance = 1e-5; // of alpha between two iterates
  Norm norm = Norm::root_mean_square;
  int max_iterations = 100;
  int anderson_depth = 2;

  static Teuchos::RCP<const Teuchos::ParameterList> validParameters();
  // step_tolerance: of the step control, from which the default follows; 0 if it has none.
  static CouplingSettings from(Teuchos::ParameterList const& parameters, double step_tolerance);
};

// The cost of solving, summed over any number of steps.
struct SolveCount
{
  std::int64_t coupled_steps = 0;
  std::int64_t rate_problems = 0; // one for each fixed point iteration
  std::int64_t tnnmg_iterations = 0;
  std::int64_t corrections = 0;
  std::int64_t correction_iterations = 0;
  std::int64_t v_cycles = 0;
  std::int64_t energy_increases = 0; // of J, see Tnnmg
  std::int64_t failures = 0;         // coupled steps without a solution

  void add(tnnmg::TnnmgResult const& result);
  SolveCount since(SolveCount const& before) const;

  struct Member
  {
    char const* name;
    std::int64_t SolveCount::*value;
  };
  // All counts with their names, to read, write or compare them one by one.
  static std::array<Member, 8> const& members();
};

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
  // budget_bytes: memory for the solvers of different step sizes, see StepSolvers. since_start: the
  // reaction that the normal stress follows, unless it is fixed. body and fault must outlive the
  // step.
  CoupledStep(Body const& body, Fault const& fault, RateUpdate const& update,
              DyadicTime const& clock, CouplingSettings const& settings,
              RateSolverSettings const& solver_settings, std::size_t budget_bytes,
              ReactionSinceStart const& since_start = {});
  // The same with these unknowns in place of unknownsOf.
  CoupledStep(Body const& body, Fault const& fault, RateUpdate const& update,
              DyadicTime const& clock, CouplingSettings const& settings,
              RateSolverSettings const& solver_settings, std::size_t budget_bytes,
              StepUnknownList unknowns);

  // The unknowns of a body and its fault, see the constructors: alpha, the normal stress, those of
  // processes, and the inelastic strain.
  static StepUnknownList unknownsOf(Body const& body, Fault const& fault,
                                    ReactionSinceStart const& since_start);

  DyadicTime const& clock() const { return clock_; }
  fem::FaultSurface const& surface() const { return fault_.surface(); }
  Body const& body() const { return body_; }
  Fault const& fault() const { return fault_; }
  RateUpdate const& update() const { return update_; }
  StepSolvers const& solvers() const { return solvers_; }
  // The right side of the last rate problem: loads, and terms from the past and from prescribed
  // velocities.
  RCP<Vector> const& lastRightSide() const { return b_; }

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
  void evaluateLoads(double t0, double t1);
  void rightSide(State const& from, double tau, State const& to);
  void setRightSide(State const& to);
  void beginUnknowns(State const& from, double tau, State const& to);
  CoupledResult iterate(State const& from, double tau, RateSolver& solver, State& to,
                        SolveCount& count);
  void meanSlipRate(RateSolver& solver);
  Vector const& displacement(RateSolver const& solver, double tau);

  Body const& body_;
  Fault const& fault_;
  RateUpdate update_;
  DyadicTime clock_;
  CouplingSettings settings_;
  StepUnknowns unknowns_;
  FrictionInput given_;
  StepSolvers solvers_;
  BodyForces forces_;
  std::int64_t num_begun_ = 0;     // steps, to tell which one may be completed
  RCP<Vector> b_without_unknowns_; // null if none adds forces
  RCP<Vector> b_, prescribed_, u_hat_, a_hat_, work_u_, work_a_, w_, work_v_;
  std::vector<RCP<Vector>> work_d_;
  // The part of the mean velocity that follows from the past and from prescribed velocities; the
  // mean velocity itself.
  BlockView mean_offset_, mean_;
  BlockView prescribed_part_;        // gatherPrescribedPart at the end of the step
  bool has_prescribed_part_ = false; // whether it has any
  NodeView V_;
};
} // namespace asperity::dynamics
