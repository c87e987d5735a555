#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/Fault.hpp"
#include "dynamics/FaultMotion.hpp"
#include "dynamics/State.hpp"
#include "dynamics/coupling/AndersonAcceleration.hpp"
#include "dynamics/coupling/NormalStressUpdate.hpp"
#include "dynamics/coupling/StepSolvers.hpp"

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

  static Teuchos::RCP<Teuchos::ParameterList> validParameters();
  static CouplingSettings from(Teuchos::ParameterList const& parameters);
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
  std::int64_t rises = 0;    // of J, see Tnnmg
  std::int64_t failures = 0; // coupled steps without a solution

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

struct CoupledResult
{
  StepStatus status = StepStatus::solved;
  int iterations = 0; // of the fixed point
  bool solved() const { return status == StepStatus::solved; }
};

// One time step: the fixed point alpha -> rate problem -> V -> state flow -> alpha (Pipping 2014,
// problem 4.3), accelerated. While alpha still changes, each rate problem gets one iteration of
// TNNMG only. The state evolves with the mean slip rate of the step,
// V = slip_factor |u1 - u0|_t / tau, which is of second order with every scheme and damped wherever
// the scheme damps u; for Newmark with beta = 1/4 it is that of thesis eq. (25) with lambda = 1/2.
// Under back slip V = |slip_factor (u1 - u0)_t / tau + Vp|.
//
// A normal stress that is coupled to the body is a second unknown of the fixed point beside alpha:
// (alpha, sigma_n) -> rate problem -> V, reaction across the fault -> (alpha, sigma_n). Each rate
// problem is convex as before, since both are fixed in it. A change of the normal stress shifts the
// state by Linker and Dieterich's term: half of the shift comes before the flow of the state law,
// half after it (Strang 1968), which is of second order.
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

  DyadicTime const& clock() const { return clock_; }
  fem::FaultSurface const& surface() const { return fault_.surface(); }
  int components() const { return body_.dofs->components(); } // of the displacement
  StepSolvers const& solvers() const { return solvers_; }
  // The right side of the last rate problem: loads, and terms from the past and from prescribed
  // velocities.
  Vector const& lastRightSide() const { return *b_; }

  // Makes a step of the given level from `from` to `to`, which must have the shapes of `from`. On
  // entry `to` holds a guess of v and alpha, and of the normal stress if it is coupled. If the step
  // fails, only alpha and the normal stress of `to`, the last iterates, may be used, in messages.
  // Collective.
  CoupledResult solve(State const& from, int level, State& to, SolveCount& count);

  // The same for the fault alone: alpha, normal stress and v there; v elsewhere is a guess, and u,
  // a and jerk are not set. This is enough for a step that is only compared with others, and saves
  // half of the elimination with the direct correction.
  CoupledResult solveAtFault(State const& from, int level, State& to, SolveCount& count);
  // Computes the rest of the step that was solved last.
  void complete(State const& from, int level, State& to);

private:
  void evaluateLoads(double t0, double t1, State& to);
  void rightSide(State const& from, double tau);
  CoupledResult iterate(State const& from, double tau, RateSolver& solver, State& to,
                        SolveCount& count);
  void meanSlipRate(RateSolver& solver);
  bool updateState(State const& from, double tau, RateSolver& solver, State const& to);
  void respond(RateSolver const& solver, State const& to);
  double changeOf(State const& to) const;
  void accelerate(State& to);

  Body const& body_;
  Fault const& fault_;
  RateUpdate update_;
  DyadicTime clock_;
  CouplingSettings settings_;
  NormalStressUpdate stress_;
  StepSolvers solvers_;
  AndersonAcceleration acceleration_;
  BodyForces forces_;
  std::optional<int> solved_level_; // of the step that may be completed
  RCP<Vector> b_, prescribed_, u_hat_, a_hat_, work_u_, work_a_, guess_;
  // The part of the mean velocity that follows from the past and from prescribed velocities; the
  // mean velocity itself.
  friction::BlockView mean_offset_, mean_;
  friction::NodeView V_, alpha_next_;
  // If the normal stress is coupled: its response [Pa]; the unknowns, alpha first and then the
  // normal stress times NormalStressUpdate::perPascal; and the image of the unknowns.
  friction::NodeView sigma_next_, unknowns_, image_;
  friction::NodeView shifted_; // alpha before the flow, if the normal stress shifts it
};
} // namespace asperity::dynamics
