#include "dynamics/coupling/CoupledStep.hpp"

#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/parameters/Parameters.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/FaultMotion.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <cmath>
#include <limits>

namespace asperity::dynamics
{
Teuchos::RCP<Teuchos::ParameterList> CouplingSettings::validParameters()
{
  const CouplingSettings defaults;
  return Declare()
    .real("Tolerance", defaults.tolerance, "-", Range::positive(),
          "The fixed-point iteration of rate and state ends when alpha changes by at most this "
          "between two iterates, in the norm chosen.")
    .choice("Norm", "Root Mean Square", {"Root Mean Square", "Maximum"},
            "Selects how that change is measured over the fault: Maximum sees a nucleation that is "
            "small beside the fault, which a mean dilutes.")
    .integer("Maximum Iterations", defaults.max_iterations, Range::atLeast(1),
             "A step is rejected after this number of fixed-point iterations. The step control "
             "then halves it; a run with prescribed steps ends.")
    .integer("Anderson Depth", defaults.anderson_depth, Range::atLeast(0),
             "Anderson acceleration extrapolates the next iterate from this number of earlier "
             "ones; 0 means the plain fixed-point iteration.")
    .list();
}

CouplingSettings CouplingSettings::from(Teuchos::ParameterList const& parameters)
{
  CouplingSettings settings;
  settings.tolerance = parameters.get<double>("Tolerance");
  settings.norm =
    parameters.get<std::string>("Norm") == "Maximum" ? Norm::maximum : Norm::root_mean_square;
  settings.max_iterations = parameters.get<int>("Maximum Iterations");
  settings.anderson_depth = parameters.get<int>("Anderson Depth");
  return settings;
}

void SolveCount::add(tnnmg::TnnmgResult const& result)
{
  tnnmg_iterations += result.iterations;
  corrections += result.corrections;
  correction_iterations += result.correction_iterations;
  v_cycles += result.v_cycles;
  rises += result.rises;
}

SolveCount SolveCount::since(SolveCount const& before) const
{
  SolveCount result;
  for (auto const& member : members()) {
    result.*member.value = this->*member.value - before.*member.value;
  }
  return result;
}

std::array<SolveCount::Member, 8> const& SolveCount::members()
{
  static constexpr std::array<Member, 8> all = {
    {{"coupled_steps", &SolveCount::coupled_steps},
     {"rate_problems", &SolveCount::rate_problems},
     {"tnnmg_iterations", &SolveCount::tnnmg_iterations},
     {"corrections", &SolveCount::corrections},
     {"correction_iterations", &SolveCount::correction_iterations},
     {"v_cycles", &SolveCount::v_cycles},
     {"rises", &SolveCount::rises},
     {"failures", &SolveCount::failures}}};
  return all;
}

CoupledStep::CoupledStep(Body const& body, Fault const& fault, RateUpdate const& update,
                         DyadicTime const& clock, CouplingSettings const& settings,
                         RateSolverSettings const& solver_settings, std::size_t budget_bytes)
    : body_(body)
    , fault_(fault)
    , update_(update)
    , clock_(clock)
    , settings_(settings)
    , solvers_(body, fault.surface(), update, clock, solver_settings, budget_bytes)
    , acceleration_(fault.surface(), settings.anderson_depth)
    , b_(body.vector())
    , prescribed_(body.vector())
    , u_hat_(body.vector())
    , a_hat_(body.vector())
    , work_u_(body.vector())
    , work_a_(body.vector())
    , guess_(body.vector())
    , mean_offset_("asperity::dynamics::meanOffset", surface().numNodes(), surface().numTangents())
    , mean_("asperity::dynamics::meanVelocity", surface().numNodes(), surface().numTangents())
    , V_("asperity::dynamics::V", surface().numNodes())
    , alpha_next_("asperity::dynamics::alphaNext", surface().numNodes())
{
}

// What the deck says about the time t1. Where that fails (an expression is no number), it may fail
// on one rank alone, and is thrown on all.
void CoupledStep::evaluateLoads(double t1, State& to)
{
  ASPERITY_TIME_WORK("right sides of steps");
  onEveryRank(*surface().communicator(), [&] {
    fault_.normalStress().at(t1, to.sigma_n);
    body_.prescribed_velocity(t1, *prescribed_);
    requireRestBesideSliding(surface(), *prescribed_, body_.dofs->components(), t1);
    body_.load(t1, *b_);
  });
}

// b = l(t1) + M a^ - K u^ - Z v_D on the free dofs, v_D the prescribed velocity: the rate problem
// is solved for w = v1 - v_D, which is zero at held dofs.
void CoupledStep::rightSide(State const& from, double tau)
{
  ASPERITY_TIME_WORK("right sides of steps");
  update_.predict(from, tau, *u_hat_, *a_hat_);
  work_a_->update(1, *a_hat_, -update_.mass_weight / tau, *prescribed_, 0);
  work_u_->update(1, *u_hat_, tau * update_.stiffness_weight, *prescribed_, 0);
  body_.matrices.mass->apply(*work_a_, *b_, Teuchos::NO_TRANS, 1, 1);
  body_.matrices.viscosity->apply(*prescribed_, *b_, Teuchos::NO_TRANS, -1, 1);
  body_.matrices.stiffness->apply(*work_u_, *b_, Teuchos::NO_TRANS, -1, 1);
  body_.clearHeld(*b_);
}

CoupledResult CoupledStep::solve(State const& from, int level, State& to, SolveCount& count)
{
  const double tau = clock_.stepSize(level);
  to.time = from.time + clock_.ticks(level);
  evaluateLoads(clock_.seconds(to.time), to);
  rightSide(from, tau);

  guess_->update(1, *to.v, -1, *prescribed_, 0);
  body_.clearHeld(*guess_);
  auto& solver = solvers_.at(level);
  solver.begin(*b_, *guess_);
  // (u^ - u0)/tau without their difference: a locked fault moves by less than the rounding of u.
  update_.laggingAcceleration(from, tau, *work_a_);
  work_u_->update(update_.velocity_in_displacement, *from.v,
                  tau * update_.acceleration_in_displacement, *work_a_, 0);
  work_u_->update(update_.stiffness_weight, *prescribed_, 1);
  gather(surface(), *work_u_, mean_offset_);

  auto const result = iterate(from, tau, solver, to, count);
  ++count.coupled_steps;
  if (!result.solved()) {
    ++count.failures;
    return result;
  }
  solver.velocity(*to.v);
  to.v->update(1, *prescribed_, 1);
  update_.complete(from, *u_hat_, *a_hat_, tau, to);
  return result;
}

// (u1 - u0)/tau at the fault nodes.
void CoupledStep::meanSlipRate(RateSolver& solver)
{
  solver.faultVelocity(mean_);
  auto const mean = mean_;
  auto const offset = mean_offset_;
  const int size = surface().numTangents();
  const double weight = update_.stiffness_weight;
  Kokkos::parallel_for(
    "asperity::dynamics::meanVelocity",
    Kokkos::RangePolicy<friction::ExecutionSpace>(0, surface().numNodes()),
    KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < size; ++k) {
        mean(node, k) = offset(node, k) + weight * mean(node, k);
      }
    });
  slipRate(surface(), mean_, V_);
}

// The state's answer to the velocity that the solver has now. False: it has none.
bool CoupledStep::updateState(State const& from, double tau, RateSolver& solver)
{
  ASPERITY_TIME_WORK("state updates");
  meanSlipRate(solver);
  return sumOverRanks(fault_.state().flow(V_, tau, from.alpha, alpha_next_),
                      *surface().communicator()) == 0;
}

// Rate problem and state take turns, one iteration of TNNMG for one update of the state: both
// contract about tenfold, and to solve a rate problem whose state is about to change is lost. Once
// the state has come to rest the rate problem is solved with it.
CoupledResult CoupledStep::iterate(State const& from, double tau, RateSolver& solver, State& to,
                                   SolveCount& count)
{
  CoupledResult result;
  acceleration_.reset();
  double last_change = std::numeric_limits<double>::infinity();
  bool at_rest = false;
  while (at_rest || result.iterations < settings_.max_iterations) {
    const FrictionProblem problem = {fault_.friction(), {to.alpha, to.sigma_n}};
    result.iterations += at_rest ? 0 : 1;
    count.rate_problems += at_rest ? 0 : 1;
    auto const rate = at_rest ? solver.solve(problem) : solver.improve(problem);
    count.add(rate);
    if (rate.failed() || (at_rest && !rate.converged)) {
      result.status = StepStatus::rate_problem_failed;
      return result;
    }
    const bool updated = updateState(from, tau, solver);
    const double change = distance(surface(), alpha_next_, to.alpha, settings_.norm);
    if (!updated || !std::isfinite(change)) {
      result.status = StepStatus::state_failed;
      return result;
    }
    at_rest = change <= settings_.tolerance;
    if (at_rest && rate.converged) {
      Kokkos::deep_copy(to.alpha_of_rate, to.alpha);
      Kokkos::deep_copy(to.alpha, alpha_next_);
      return result;
    }
    if (!at_rest) {
      if (change > last_change) {
        acceleration_.reset(); // the remembered iterates point away from the fixed point
      }
      acceleration_.advance(to.alpha, alpha_next_);
      last_change = change;
    }
  }
  result.status = StepStatus::fixed_point_failed;
  return result;
}
} // namespace asperity::dynamics
