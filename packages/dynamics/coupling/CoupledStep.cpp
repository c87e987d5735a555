#include "dynamics/coupling/CoupledStep.hpp"

#include "parameters/Entries.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/coupling/InelasticUpdate.hpp"
#include "dynamics/coupling/NormalStressUpdate.hpp"
#include "dynamics/coupling/StateUpdate.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "parameters/Parameters.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>
#include <cmath>

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
  energy_increases += result.energy_increases;
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
     {"rises", &SolveCount::energy_increases},
     {"failures", &SolveCount::failures}}};
  return all;
}

StepUnknownList CoupledStep::unknownsOf(Body const& body, Fault const& fault,
                                        ReactionSinceStart const& since_start)
{
  StepUnknownList all = {std::make_shared<StateUpdate>(fault),
                         std::make_shared<NormalStressUpdate>(body, fault, since_start)};
  for (auto const& process : fault.processes()) {
    auto const of_process = process->unknowns();
    all.insert(all.end(), of_process.begin(), of_process.end());
  }
  if (body.cells) {
    all.push_back(std::make_shared<InelasticUpdate>(*body.cells));
  }
  return all;
}

CoupledStep::CoupledStep(Body const& body, Fault const& fault, RateUpdate const& update,
                         DyadicTime const& clock, CouplingSettings const& settings,
                         RateSolverSettings const& solver_settings, std::size_t budget_bytes,
                         ReactionSinceStart const& since_start)
    : CoupledStep(body, fault, update, clock, settings, solver_settings, budget_bytes,
                  unknownsOf(body, fault, since_start))
{
}

CoupledStep::CoupledStep(Body const& body, Fault const& fault, RateUpdate const& update,
                         DyadicTime const& clock, CouplingSettings const& settings,
                         RateSolverSettings const& solver_settings, std::size_t budget_bytes,
                         StepUnknownList unknowns)
    : body_(body)
    , fault_(fault)
    , update_(update)
    , clock_(clock)
    , settings_(settings)
    , unknowns_(fault.surface(), settings.anderson_depth, std::move(unknowns))
    , given_(fault.processes(), fault.surface().numNodes())
    , solvers_(body, fault.surface(), update, clock, solver_settings, budget_bytes,
               unknowns_.reaction())
    , forces_(body.noForces())
    , b_without_unknowns_(unknowns_.addForces() ? body.vector() : Teuchos::null)
    , b_(body.vector())
    , prescribed_(body.vector())
    , u_hat_(body.vector())
    , a_hat_(body.vector())
    , work_u_(body.vector())
    , work_a_(body.vector())
    , w_(body.vector())
    , work_v_(body.vector())
    , work_d_(body.branchVectors())
    , mean_offset_("asperity::dynamics::meanOffset", surface().numNodes(), surface().numTangents())
    , mean_("asperity::dynamics::meanVelocity", surface().numNodes(), surface().numTangents())
    , prescribed_part_("asperity::dynamics::prescribedBeside", surface().numNodes(),
                       surface().numTangents())
    , V_("asperity::dynamics::V", surface().numNodes())
{
}

// Evaluates the expressions of the deck at the time t1. One of them may be nan on one rank alone;
// the error is thrown on all ranks.
void CoupledStep::evaluateLoads(double t0, double t1)
{
  ASPERITY_TIME_WORK("right sides of steps");
  onEveryRank(*surface().communicator(), [&] {
    unknowns_.evaluate(t0, t1);
    body_.prescribed_velocity(t1, *prescribed_);
    has_prescribed_part_ = gatherPrescribedPart(surface(), *prescribed_, prescribed_part_);
    setZeroSlipRate(surface(), *prescribed_);
    body_.load(t1, *b_);
  });
}

// b = l(t1) - M a_D - C v_D - K u_D - sum of K_k d_D on the free dofs, where v_D is the prescribed
// velocity, and u_D, a_D and d_D follow from it by the rate update: the rate problem is solved for
// w = v1 - v_D, which is zero at held dofs. Under back slip v_D is the motion of the plates at the
// free dofs of the fault, so that friction depends on w there (gatherSlip). Where a held dof of the
// fault slips beside a free one, friction depends on the prescribed rate of it, too.
void CoupledStep::rightSide(State const& from, double tau, State const& to)
{
  ASPERITY_TIME_WORK("right sides of steps");
  update_.predict(from, tau, *u_hat_, *a_hat_);
  update_.withVelocity(*prescribed_, *u_hat_, *a_hat_, tau, *work_u_, *work_a_);
  RateUpdate::relax(body_.matrices, from, tau, *work_u_, work_d_);
  body_.computeForces({*work_u_, *prescribed_, *work_a_, work_d_}, forces_);
  forces_.subtractFrom(*b_);
  if (!b_without_unknowns_.is_null()) {
    Tpetra::deep_copy(*b_without_unknowns_, *b_);
  }
  setRightSide(to);
}

// The right side with the iterates in `to`.
void CoupledStep::setRightSide(State const& to)
{
  if (!b_without_unknowns_.is_null()) {
    Tpetra::deep_copy(*b_, *b_without_unknowns_);
    unknowns_.addForces(to, *b_);
  }
  unknowns_.setRightSide(*b_);
  body_.clearHeld(*b_);
}

CoupledResult CoupledStep::solve(State const& from, int level, State& to, SolveCount& count)
{
  auto result = solveAtFault(from, level, to, count);
  if (result.solved()) {
    complete(*result.rest, from, to);
    result.rest.reset();
  }
  return result;
}

CoupledResult CoupledStep::solveAtFault(State const& from, int level, State& to, SolveCount& count)
{
  ++num_begun_;
  const double tau = clock_.stepSize(level);
  to.time = from.time + clock_.ticks(level);
  evaluateLoads(clock_.seconds(from.time), clock_.seconds(to.time));
  beginUnknowns(from, tau, to);
  rightSide(from, tau, to);

  w_->update(1, *to.v, -1, *prescribed_, 0);
  body_.clearHeld(*w_);
  auto& solver = solvers_.at(level);
  solver.begin(*b_, *w_);
  update_.meanVelocity(from, tau, *prescribed_, surface().dofs(), *work_u_);
  gatherSlip(surface(), *work_u_, mean_offset_);

  auto result = iterate(from, tau, solver, to, count);
  ++count.coupled_steps;
  if (!result.solved()) {
    ++count.failures;
    return result;
  }
  solver.knownVelocity(*w_);
  to.v->update(1, *w_, 1, *prescribed_, 0);
  result.rest = PendingStep{level, num_begun_};
  return result;
}

// mean_ has the velocity at the beginning until the first rate problem is solved.
void CoupledStep::beginUnknowns(State const& from, double tau, State const& to)
{
  gatherSlip(surface(), *from.v, mean_);
  const FrictionProblem friction = {fault_.friction(),
                                    {from.alpha_of_rate, given_.at(from).sigma_n}};
  unknowns_.begin({from, clock_.seconds(from.time), tau, mean_, friction, to});
}

void CoupledStep::complete(PendingStep const& step, State const& from, State& to)
{
  ASPERITY_ASSERT(step.number == num_begun_ && to.time == from.time + clock_.ticks(step.level));
  if (!unknowns_.followFromBody()) { // else solveAtFault() has set all of v
    solvers_.at(step.level).velocity(*to.v);
    to.v->update(1, *prescribed_, 1);
  }
  const double tau = clock_.stepSize(step.level);
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

// At the end of the step, from the velocity of the body, with which it leaves w_.
Vector const& CoupledStep::displacement(RateSolver const& solver, double tau)
{
  solver.velocity(*w_);
  work_v_->update(1, *w_, 1, *prescribed_, 0);
  update_.withVelocity(*work_v_, *u_hat_, *a_hat_, tau, *work_u_, *work_a_);
  return *work_u_;
}

// Alternates one iteration of TNNMG and one update of the unknowns: both reduce the error by
// similar factors, and more iterations for unknowns that still change would be wasted. When they
// have converged, the rate problem is solved with them.
CoupledResult CoupledStep::iterate(State const& from, double tau, RateSolver& solver, State& to,
                                   SolveCount& count)
{
  CoupledResult result;
  bool converged = false;
  while (converged || result.iterations < settings_.max_iterations) {
    auto const given = given_.at(to);
    const FrictionProblem friction = {fault_.friction(), given}; // of the whole slip rate
    FrictionProblem const problem =
      has_prescribed_part_ ? friction.withPrescribed(prescribed_part_) : friction; // of w
    result.iterations += converged ? 0 : 1;
    count.rate_problems += converged ? 0 : 1;
    auto const rate = converged ? solver.solve(problem) : solver.improve(problem);
    count.add(rate);
    if (rate.failed() || (converged && !rate.converged)) {
      result.status = StepStatus::rate_problem_failed;
      return result;
    }
    meanSlipRate(solver);
    StepIterate now = {from, tau, mean_, V_, solver, friction, to};
    double change = unknowns_.updateImages(FollowsFrom::fault, now, settings_.norm);
    if (unknowns_.bodyIsDue(change, rate.converged, settings_.tolerance)) {
      now.u_in_body = &displacement(solver, tau);
      const double in_body = unknowns_.updateImages(FollowsFrom::body, now, settings_.norm);
      change = in_body <= change ? change : in_body; // which may be nan
    }
    if (!std::isfinite(change)) {
      unknowns_.copyImages(to); // a value that is not finite can be found there
      result.status = StepStatus::state_failed;
      return result;
    }
    converged = change <= settings_.tolerance;
    if (converged && rate.converged) {
      Kokkos::deep_copy(to.alpha_of_rate, given.alpha);
      unknowns_.finish(to);
      return result;
    }
    if (!converged && unknowns_.advance(to)) {
      setRightSide(to);
      if (now.u_in_body == nullptr) { // else displacement() has left it in w_
        solver.velocity(*w_);
      }
      solver.begin(*b_, *w_);
    }
  }
  result.status = StepStatus::fixed_point_failed;
  return result;
}
} // namespace asperity::dynamics
