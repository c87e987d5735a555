#include "dynamics/coupling/CoupledStep.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/coupling/InelasticUpdate.hpp"
#include "dynamics/coupling/NormalStressUpdate.hpp"
#include "dynamics/coupling/StateUpdate.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_CrsMatrix.hpp>

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
} // namespace

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
    , mean_offset_("asperity::dynamics::meanOffset", surface().numNodes(), surface().numTangents())
    , prescribed_part_("asperity::dynamics::prescribedBeside", surface().numNodes(),
                       surface().numTangents())
    , work_{body.vector(),
            body.vector(),
            body.vector(),
            body.vector(),
            body.branchVectors(),
            BlockView("asperity::dynamics::meanVelocity", surface().numNodes(),
                      surface().numTangents()),
            NodeView("asperity::dynamics::V", surface().numNodes())}
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
  update_.withVelocity(*prescribed_, *u_hat_, *a_hat_, tau, *work_.u, *work_.a);
  RateUpdate::relax(body_.matrices, from, tau, *work_.u, work_.d);
  body_.computeForces({*work_.u, *prescribed_, *work_.a, work_.d}, forces_);
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

  setMeanOffset(from, tau);

  Vector& w = *work_.w; // v - v_D, first of the guess
  w.update(1, *to.v, -1, *prescribed_, 0);
  body_.clearHeld(w);
  auto& solver = solvers_.at(level);
  solver.begin(*b_, w);
  auto result = iterate(from, tau, solver, w, to, count);
  ++count.coupled_steps;
  if (!result.solved()) {
    ++count.failures;
    return result;
  }
  solver.knownVelocity(w);
  to.v->update(1, w, 1, *prescribed_, 0);
  result.rest = PendingStep{level, num_begun_};
  return result;
}

// The part of the mean velocity that follows from the past and from prescribed velocities.
void CoupledStep::setMeanOffset(State const& from, double tau)
{
  update_.meanVelocity(from, tau, *prescribed_, surface().dofs(), *work_.u);
  gatherSlip(surface(), *work_.u, mean_offset_);
}

void CoupledStep::beginUnknowns(State const& from, double tau, State const& to)
{
  BlockView const& velocity = work_.mean;
  gatherSlip(surface(), *from.v, velocity);
  const FrictionProblem friction = {fault_.friction(),
                                    {from.alpha_of_rate, given_.at(from).sigma_n}};
  unknowns_.begin({from, clock_.seconds(from.time), tau, velocity, friction, to});
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

// mean: w of gatherSlip, mean over the step. V = |chi (u1 - u0)_t / tau + Vp| at the fault nodes.
void CoupledStep::meanSlipRate(RateSolver const& solver, BlockView const& mean,
                               NodeView const& V) const
{
  ASPERITY_TIME_WORK("state updates");
  solver.faultVelocity(mean);
  meanVelocity(mean_offset_, update_.stiffness_weight, mean);
  slipRate(surface(), mean, V);
}

// u at the end of the step from w = v1 - v_D of the whole body.
void CoupledStep::displacementAtEnd(Vector const& w, double tau, Vector& u) const
{
  work_.v->update(1, w, 1, *prescribed_, 0);
  update_.withVelocity(*work_.v, *u_hat_, *a_hat_, tau, u, *work_.a);
}

// friction: of the whole slip rate; the rate problem has that of w alone.
tnnmg::TnnmgResult CoupledStep::workOn(Effort effort, FrictionProblem const& friction,
                                       RateSolver& solver) const
{
  FrictionProblem const problem =
    has_prescribed_part_ ? friction.withPrescribed(prescribed_part_) : friction;
  return effort == Effort::solution ? solver.solve(problem) : solver.improve(problem);
}

// Works on the rate problem with the iterates in `to`, and computes the images that follow. Sets w
// where images follow from the whole body.
CoupledStep::Response CoupledStep::respond(Effort effort, State const& from, double tau,
                                           RateSolver& solver, Vector& w, State& to,
                                           SolveCount& count)
{
  auto const given = given_.at(to);
  const FrictionProblem friction = {fault_.friction(), given};
  auto const rate = workOn(effort, friction, solver);
  count.add(rate);
  Response response;
  response.rate_converged = rate.converged;
  response.alpha = given.alpha;
  if (rate.failed() || (effort == Effort::solution && !rate.converged)) {
    response.status = StepStatus::rate_problem_failed;
    return response;
  }
  meanSlipRate(solver, work_.mean, work_.V);
  StepIterate now = {from, tau, work_.mean, work_.V, solver, friction, to};
  response.change = unknowns_.updateImages(FollowsFrom::fault, now, settings_.norm);
  if (unknowns_.bodyIsDue(response.change, rate.converged, settings_.tolerance)) {
    solver.velocity(w);
    response.has_velocity = true;
    displacementAtEnd(w, tau, *work_.u);
    now.u_in_body = work_.u.get();
    const double in_body = unknowns_.updateImages(FollowsFrom::body, now, settings_.norm);
    response.change = in_body <= response.change ? response.change : in_body; // which may be nan
  }
  if (!std::isfinite(response.change)) {
    unknowns_.copyImages(to); // a value that is not finite can be found there
    response.status = StepStatus::state_failed;
  }
  return response;
}

// Alternates one iteration of TNNMG and one update of the unknowns: both reduce the error by
// similar factors, and more iterations for unknowns that still change would be wasted. When they
// have converged, the rate problem is solved with them. On entry w has the guess with which the
// solver began, on return the last velocity of the whole body that was computed.
CoupledResult CoupledStep::iterate(State const& from, double tau, RateSolver& solver, Vector& w,
                                   State& to, SolveCount& count)
{
  CoupledResult result;
  while (result.iterations < settings_.max_iterations) {
    ++result.iterations;
    ++count.rate_problems;
    auto response = respond(Effort::one_iteration, from, tau, solver, w, to, count);
    if (response.status == StepStatus::solved && response.change <= settings_.tolerance &&
        !response.rate_converged) {
      response = respond(Effort::solution, from, tau, solver, w, to, count);
    }
    if (response.status != StepStatus::solved) {
      result.status = response.status;
      return result;
    }
    if (response.change <= settings_.tolerance) {
      Kokkos::deep_copy(to.alpha_of_rate, response.alpha);
      unknowns_.finish(to);
      return result;
    }
    if (unknowns_.advance(to)) {
      setRightSide(to);
      if (!response.has_velocity) {
        solver.velocity(w);
      }
      solver.begin(*b_, w);
    }
  }
  result.status = StepStatus::fixed_point_failed;
  return result;
}
} // namespace asperity::dynamics
