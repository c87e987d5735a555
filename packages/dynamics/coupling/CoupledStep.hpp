#pragma once

#include "dynamics/Body.hpp"
#include "dynamics/Fault.hpp"
#include "dynamics/FaultMotion.hpp"
#include "dynamics/State.hpp"
#include "dynamics/coupling/AndersonAcceleration.hpp"
#include "dynamics/coupling/NormalStressUpdate.hpp"
#include "dynamics/coupling/StepSolvers.hpp"

#include <array>

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

// What solving cost, summed over any number of steps.
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
  // All of them, for whoever reads, writes or compares them one by one.
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
// problem 4.3), accelerated, the rate problem solved as far as the state is. The state sees the
// mean slip rate of the step, V = slip_factor |u1 - u0|_t / tau, which is of second order with
// every scheme and damped wherever the scheme damps u; it is that of thesis eq. (25), lambda = 1/2,
// for Newmark with beta = 1/4. Under back slip V = |slip_factor (u1 - u0)_t / tau + Vp|.
//
// A normal stress that is coupled to the body is a second unknown of the fixed point beside alpha:
// (alpha, sigma_n) -> rate problem -> V, reaction across the fault -> (alpha, sigma_n). Each rate
// problem is convex as before, since both are fixed in it. A change of the normal stress moves the
// state by Linker and Dieterich's term: half of it before the flow of the state law and half after
// (Strang 1968), which is of second order.
class CoupledStep
{
public:
  // budget_bytes: of the solvers of different step sizes, see StepSolvers. since_start: what the
  // normal stress follows, unless it is fixed. body and fault must outlive the step.
  CoupledStep(Body const& body, Fault const& fault, RateUpdate const& update,
              DyadicTime const& clock, CouplingSettings const& settings,
              RateSolverSettings const& solver_settings, std::size_t budget_bytes,
              ReactionSinceStart const& since_start = {});

  DyadicTime const& clock() const { return clock_; }
  fem::FaultSurface const& surface() const { return fault_.surface(); }
  StepSolvers const& solvers() const { return solvers_; }

  // From `from` over a step of the given level to `to`, which must have the shapes of `from`. `to`
  // holds a guess of v and alpha, and of a coupled normal stress, on entry; where the step fails
  // its content is of no use. All ranks together.
  CoupledResult solve(State const& from, int level, State& to, SolveCount& count);

private:
  void evaluateLoads(double t0, double t1, State& to);
  void rightSide(State const& from, double tau);
  CoupledResult iterate(State const& from, double tau, RateSolver& solver, State& to,
                        SolveCount& count);
  void meanSlipRate(RateSolver& solver);
  bool updateState(State const& from, double tau, RateSolver& solver, State const& to);
  void shiftByStress(State const& from, State const& to, friction::ConstNodeView const& alpha,
                     friction::NodeView const& shifted) const;
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
  RCP<Vector> b_, prescribed_, u_hat_, a_hat_, work_u_, work_a_, guess_;
  // What the mean velocity owes to the past and to prescribed velocities; the mean itself.
  friction::BlockView mean_offset_, mean_;
  friction::NodeView V_, alpha_next_;
  // Where the normal stress is coupled: its answer, in Pa; alpha and the normal stress in units of
  // NormalStressUpdate::perPascal, one after the other, and what they are mapped to.
  friction::NodeView sigma_next_, unknowns_, image_;
  friction::NodeView shifted_; // alpha before the flow, where the normal stress moves it
};
} // namespace asperity::dynamics
