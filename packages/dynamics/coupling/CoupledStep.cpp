#include "dynamics/coupling/CoupledStep.hpp"

#include "parameters/Entries.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/coupling/StateUpdate.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "parameters/Parameters.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::dynamics
{
namespace
{
// mean := offset + weight mean, (num_nodes, T)
void meanVelocity(ConstBlockView const& offset, double weight, BlockView const& mean)
{
  Kokkos::parallel_for(
    "asperity::dynamics::meanVelocity", RangePolicy(0, mean.extent_int(0)),
    KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < mean.extent_int(1); ++k) {
        mean(node, k) = offset(node, k) + weight * mean(node, k);
      }
    });
}

Entries<CouplingSettings> couplingEntries()
{
  CouplingSettings defaults;
  defaults.tolerance = 0; // follows from the step control
  return Entries<CouplingSettings>(defaults)
    .real("Tolerance", &CouplingSettings::tolerance, "-", Range::closedOpen(0, 1),
          "The fixed-point iteration of rate and state ends when alpha changes by at most this "
          "between two iterates, in the norm chosen. 0 means a thousandth of the Tolerance of the "
          "step control, but at most 1e-5, which also holds for prescribed steps.")
    .choice("Norm", &CouplingSettings::norm, normWords(),
            "Selects how that change is measured over the fault. Maximum also responds to a "
            "nucleation much smaller than the fault, which has little weight in a mean.")
    .integer("Maximum Iterations", &CouplingSettings::max_iterations, Range::atLeast(1),
             "A step is rejected after this number of fixed-point iterations. The step control "
             "then halves it; a run with prescribed steps ends.")
    .integer("Anderson Depth", &CouplingSettings::anderson_depth, Range::atLeast(0),
             "Anderson acceleration extrapolates the next iterate from this number of earlier "
             "ones; 0 means the plain fixed-point iteration.");
}
} // namespace

Teuchos::RCP<const Teuchos::ParameterList> CouplingSettings::validParameters()
{
  return couplingEntries().list();
}

CouplingSettings CouplingSettings::from(Teuchos::ParameterList const& parameters,
                                        double step_tolerance)
{
  constexpr double share_of_steps = 1e-3;
  auto settings = couplingEntries().read(parameters, "Asperity / Coupling");
  if (settings.tolerance == 0) {
    settings.tolerance = CouplingSettings().tolerance;
    if (step_tolerance > 0) {
      settings.tolerance = std::min(settings.tolerance, share_of_steps * step_tolerance);
    }
  }
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
                         RateSolverSettings const& solver_settings, std::size_t budget_bytes,
                         ReactionSinceStart const& since_start)
    : body_(body)
    , fault_(fault)
    , update_(update)
    , clock_(clock)
    , settings_(settings)
    , unknowns_(fault.surface(), settings.anderson_depth)
    , stress_(std::make_shared<NormalStressUpdate>(body, fault, since_start))
    , solvers_(body, fault.surface(), update, clock, solver_settings, budget_bytes,
               stress_->coupled() ? since_start.reaction : nullptr)
    , forces_(body.noForces())
    , b_(body.vector())
    , prescribed_(body.vector())
    , u_hat_(body.vector())
    , a_hat_(body.vector())
    , work_u_(body.vector())
    , work_a_(body.vector())
    , guess_(body.vector())
    , work_v_(body.vector())
    , work_d_(body.branchVectors())
    , mean_offset_("asperity::dynamics::meanOffset", surface().numNodes(), surface().numTangents())
    , mean_("asperity::dynamics::meanVelocity", surface().numNodes(), surface().numTangents())
    , beside_("asperity::dynamics::prescribedBeside", surface().numNodes(), surface().numTangents())
    , V_("asperity::dynamics::V", surface().numNodes())
{
  if (body.cells) {
    inelastic_.emplace(*body.cells, settings.anderson_depth);
  }
  unknowns_.add(std::make_shared<StateUpdate>(fault));
  if (stress_->coupled()) {
    unknowns_.add(stress_);
  }
  for (auto const& process : fault.processes()) {
    for (auto const& unknown : process->unknowns()) {
      unknowns_.add(unknown);
    }
  }
}

double CoupledStep::distance(State const& a, State const& b, Norm norm) const
{
  const double of_fault = unknowns_.distance(a, b, norm);
  const double of_rock = inelastic_ ? inelastic_->distance(a, b, norm) : 0;
  return std::isfinite(of_rock) ? std::max(of_fault, of_rock) : of_rock;
}

// Evaluates the expressions of the deck at the time t1. One of them may be nan on one rank alone;
// the error is thrown on all ranks.
void CoupledStep::evaluateLoads(double t0, double t1)
{
  ASPERITY_TIME_WORK("right sides of steps");
  onEveryRank(*surface().communicator(), [&] {
    stress_->evaluate(t0, t1);
    body_.prescribed_velocity(t1, *prescribed_);
    slips_beside_ = prescribedBesideSliding(surface(), *prescribed_, beside_);
    setZeroSlipRate(surface(), *prescribed_);
    body_.load(t1, *b_);
  });
}

// b = l(t1) - M a_D - C v_D - K u_D - sum of K_k d_D on the free dofs, where v_D is the prescribed
// velocity, and u_D, a_D and d_D follow from it by the rate update: the rate problem is solved for
// w = v1 - v_D, which is zero at held dofs. Under back slip v_D is the motion of the plates at the
// free dofs of the fault, so that friction depends on w there (gatherSlip). Where a held dof of the
// fault slips beside a free one, friction depends on the prescribed rate of it, too.
void CoupledStep::rightSide(State const& from, double tau, State& to)
{
  ASPERITY_TIME_WORK("right sides of steps");
  update_.predict(from, tau, *u_hat_, *a_hat_);
  update_.withVelocity(*prescribed_, *u_hat_, *a_hat_, tau, *work_u_, *work_a_);
  RateUpdate::relax(body_.matrices, from, tau, *work_u_, work_d_);
  body_.computeForces({*work_u_, *prescribed_, *work_a_, work_d_}, forces_);
  forces_.subtractFrom(*b_);
  if (inelastic_) {
    inelastic_->begin(*b_);
  }
  stress_->begin(from, to);
  setRightSide(to);
}

// The right side with the inelastic strain of `to`.
void CoupledStep::setRightSide(State const& to)
{
  if (inelastic_) {
    inelastic_->rightSide(to, *b_);
  }
  stress_->setRightSide(*b_);
  body_.clearHeld(*b_);
}

CoupledResult CoupledStep::solve(State const& from, int level, State& to, SolveCount& count)
{
  auto result = solveAtFault(from, level, to, count);
  if (result.solved()) {
    std::move(*result.rest).complete(to);
    result.rest.reset();
  }
  return result;
}

CoupledResult CoupledStep::solveAtFault(State const& from, int level, State& to, SolveCount& count)
{
  ++num_solved_;
  const double tau = clock_.stepSize(level);
  to.time = from.time + clock_.ticks(level);
  evaluateLoads(clock_.seconds(from.time), clock_.seconds(to.time));
  rightSide(from, tau, to);
  for (auto const& process : fault_.processes()) {
    process->begin(from, clock_.seconds(from.time), tau, to);
  }

  guess_->update(1, *to.v, -1, *prescribed_, 0);
  body_.clearHeld(*guess_);
  auto& solver = solvers_.at(level);
  solver.begin(*b_, *guess_);
  update_.meanVelocity(from, tau, *prescribed_, surface().dofs(), *work_u_);
  gatherSlip(surface(), *work_u_, mean_offset_);
  beginUnknowns(from, tau, to);

  auto result = iterate(from, tau, solver, to, count);
  ++count.coupled_steps;
  if (!result.solved()) {
    ++count.failures;
    return result;
  }
  solver.knownVelocity(*guess_);
  to.v->update(1, *guess_, 1, *prescribed_, 0);
  result.rest = PendingStep(*this, from, level, num_solved_);
  return result;
}

// mean_ has the velocity at the beginning until the first rate problem is solved.
void CoupledStep::beginUnknowns(State const& from, double tau, State const& to)
{
  gatherSlip(surface(), *from.v, mean_);
  const FrictionProblem friction = {fault_.friction(),
                                    {from.alpha_of_rate, fault_.given(from).sigma_n}};
  unknowns_.begin({from, tau, mean_, friction, to});
}

void PendingStep::complete(State& to) &&
{
  ASPERITY_ASSERT(number_ == step_->num_solved_);
  step_->complete(*from_, level_, to);
}

void CoupledStep::complete(State const& from, int level, State& to)
{
  if (!inelastic_) { // where rock may yield, solveAtFault() has set all of v
    solvers_.at(level).velocity(*to.v);
    to.v->update(1, *prescribed_, 1);
  }
  const double tau = clock_.stepSize(level);
  update_.complete(from, *u_hat_, *a_hat_, tau, to);
  RateUpdate::relax(body_.matrices, from, tau, *to.u, to.branches);
  unknowns_.complete(from, tau, to);
}

// |c (u1 - u0)_t / tau + Vp| at the fault nodes.
void CoupledStep::meanSlipRate(RateSolver& solver)
{
  ASPERITY_TIME_WORK("state updates");
  solver.faultVelocity(mean_);
  meanVelocity(mean_offset_, update_.stiffness_weight, mean_);
  slipRate(surface(), mean_, V_);
}

// How far the inelastic strain is from what follows from the velocity of the body, with which it
// leaves guess_.
double CoupledStep::inelasticChange(State const& from, double tau, RateSolver const& solver,
                                    State const& to)
{
  solver.velocity(*guess_);
  work_v_->update(1, *guess_, 1, *prescribed_, 0);
  update_.withVelocity(*work_v_, *u_hat_, *a_hat_, tau, *work_u_, *work_a_);
  inelastic_->respond(*work_u_, tau, from);
  return inelastic_->change(to, settings_.norm);
}

// Sets the next iterate of the inelastic strain, which changes the right side of the rate problem.
void CoupledStep::advanceInelastic(RateSolver& solver, State& to)
{
  inelastic_->advance(to);
  setRightSide(to);
  solver.begin(*b_, *guess_);
}

// Alternates one iteration of TNNMG and one update of the state: both reduce the error by similar
// factors, and more iterations for a state that still changes would be wasted. When the state has
// converged, the rate problem is solved with it. The response of rock that yields takes the whole
// body: it waits until the fault has converged, or changes less than the rock did when last asked
// and the rock is expected to change further.
CoupledResult CoupledStep::iterate(State const& from, double tau, RateSolver& solver, State& to,
                                   SolveCount& count)
{
  CoupledResult result;
  unknowns_.restart();
  double last_change = std::numeric_limits<double>::infinity();
  bool converged = false;
  while (converged || result.iterations < settings_.max_iterations) {
    auto const given = fault_.given(to);
    const FrictionProblem friction = {fault_.friction(), given}; // of the whole slip rate
    FrictionProblem const problem = slips_beside_ ? friction.beside(beside_) : friction; // of w
    result.iterations += converged ? 0 : 1;
    count.rate_problems += converged ? 0 : 1;
    auto const rate = converged ? solver.solve(problem) : solver.improve(problem);
    count.add(rate);
    if (rate.failed() || (converged && !rate.converged)) {
      result.status = StepStatus::rate_problem_failed;
      return result;
    }
    meanSlipRate(solver);
    const bool responded = unknowns_.respond({from, tau, mean_, V_, solver, friction, to});
    const double of_fault = unknowns_.change(settings_.norm);
    const bool fault_converged = rate.converged && of_fault <= settings_.tolerance;
    const bool asks_rock =
      inelastic_ && (fault_converged || (of_fault <= inelastic_->lastChange() &&
                                         inelastic_->expectedChange() > settings_.tolerance));
    const double of_rock = asks_rock ? inelasticChange(from, tau, solver, to) : 0;
    const double change = std::max(of_fault, of_rock);
    if (!responded || !std::isfinite(of_fault) || !std::isfinite(of_rock)) {
      unknowns_.copyImages(to); // a value that is not finite can be found there
      if (inelastic_) {
        inelastic_->copyImage(to);
      }
      result.status = StepStatus::state_failed;
      return result;
    }
    converged = change <= settings_.tolerance;
    if (converged && rate.converged) {
      Kokkos::deep_copy(to.alpha_of_rate, given.alpha);
      unknowns_.finish(to);
      if (inelastic_) {
        inelastic_->copyImage(to);
      }
      return result;
    }
    if (!converged) {
      if (of_fault > last_change) { // the remembered iterates point away from the fixed point
        unknowns_.restart();
      }
      unknowns_.advance(to);
      if (asks_rock) {
        advanceInelastic(solver, to);
      }
      last_change = of_fault;
    }
  }
  result.status = StepStatus::fixed_point_failed;
  return result;
}
} // namespace asperity::dynamics
