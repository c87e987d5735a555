#include "dynamics/coupling/CoupledStep.hpp"

#include "base/Errors.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/coupling/InelasticUpdate.hpp"
#include "dynamics/coupling/NormalStressUpdate.hpp"
#include "dynamics/coupling/StateUpdate.hpp"
#include "dynamics/fault/FaultMotion.hpp"

#include <cmath>

namespace asperity::dynamics
{
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

CoupledStep::CoupledStep(Body const& body, Fault const& fault, StepSettings const& settings,
                         ReactionSinceStart const& since_start)
    : CoupledStep(body, fault, settings, unknownsOf(body, fault, since_start), since_start)
{
}

CoupledStep::CoupledStep(Body const& body, Fault const& fault, StepSettings const& settings,
                         StepUnknownList unknowns, ReactionSinceStart const& since_start)
    : body_(body)
    , fault_(fault)
    , settings_(settings)
    , unknowns_(fault.surface(), settings.coupling.anderson_depth, std::move(unknowns))
    , given_(fault.processes(), fault.surface().numNodes())
    , solvers_(body, fault.surface(), settings.update, settings.clock, settings.solver,
               settings.solver_memory, unknowns_.reaction())
    , equations_(body, fault, settings_.update, unknowns_, since_start)
    , w_(body.vector())
    , start_velocity_("asperity::dynamics::startVelocity", surface().numNodes(),
                      surface().numTangents())
    , mean_velocity_("asperity::dynamics::meanVelocity", surface().numNodes(),
                     surface().numTangents())
    , slip_rate_("asperity::dynamics::V", surface().numNodes())
{
  if (surface().mayOpen()) {
    memory_.emplace(surface().numNodes(), surface().numTangents());
  }
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
  const double tau = clock().stepSize(level);
  to.time = from.time + clock().ticks(level);
  equations_.begin(from, tau, clock().seconds(from.time), clock().seconds(to.time));
  beginUnknowns(from, tau, to);

  Vector& w = *w_; // first of the guess
  equations_.removePrescribed(*to.v, w);
  auto& solver = solvers_.at(level);
  solver.begin(equations_.setRightSide(to), w);
  auto result = iterate(from, tau, solver, w, to, count);
  ++count.coupled_steps;
  if (!result.solved()) {
    ++count.failures;
    return result;
  }
  solver.knownVelocity(w);
  equations_.addPrescribed(w, *to.v);
  result.rest = PendingStep{level, num_begun_};
  return result;
}

void CoupledStep::beginUnknowns(State const& from, double tau, State const& to)
{
  gatherSlip(surface(), *from.v, start_velocity_);
  const FrictionProblem friction = {fault_.friction(),
                                    {from.alpha_of_rate, given_.at(from).sigma_n}};
  unknowns_.begin({from, clock().seconds(from.time), tau, start_velocity_, friction, to});
}

void CoupledStep::complete(PendingStep const& step, State const& from, State& to)
{
  ASPERITY_ASSERT(step.number == num_begun_ && to.time == from.time + clock().ticks(step.level));
  if (!unknowns_.followFromBody()) { // else solveAtFault() has set all of v
    solvers_.at(step.level).velocity(*to.v);
    equations_.addPrescribed(*to.v, *to.v);
  }
  const double tau = clock().stepSize(step.level);
  equations_.complete(from, tau, to);
  unknowns_.complete(from, tau, to);
}

// mean: w of gatherSlip, mean over the step. V = |chi (u1 - u0)_t / tau + Vp| at the fault nodes.
void CoupledStep::meanSlipRate(RateSolver const& solver, BlockView const& mean,
                               NodeView const& V) const
{
  ASPERITY_TIME_WORK("state updates");
  solver.faultVelocity(mean);
  equations_.takeMean(mean);
  slipRate(surface(), mean, V);
}

// friction: of the whole slip rate; the rate problem has that of w alone.
tnnmg::TnnmgResult CoupledStep::workOn(Effort effort, FrictionProblem const& friction,
                                       RateSolver& solver) const
{
  auto const problem = equations_.withPrescribed(friction);
  const auto work = [&](tnnmg::NodalProblem const& one) {
    return effort == Effort::solution ? solver.solve(one) : solver.improve(one);
  };
  return memory_ ? work(OpeningProblem(problem, equations_.opening()->bounds(), *memory_))
                 : work(problem);
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
  auto const& settings = settings_.coupling;
  meanSlipRate(solver, mean_velocity_, slip_rate_);
  StepIterate now = {from, tau, mean_velocity_, slip_rate_, solver, friction, to};
  now.opening = equations_.opening();
  response.change = unknowns_.updateImages(FollowsFrom::fault, now, settings.norm);
  if (unknowns_.bodyIsDue(response.change, rate.converged, settings.tolerance)) {
    solver.velocity(w);
    response.has_velocity = true;
    now.u_in_body = &equations_.displacementAtEnd(w, tau);
    const double in_body = unknowns_.updateImages(FollowsFrom::body, now, settings.norm);
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
  auto const& settings = settings_.coupling;
  CoupledResult result;
  while (result.iterations < settings.max_iterations) {
    ++result.iterations;
    ++count.rate_problems;
    auto response = respond(Effort::one_iteration, from, tau, solver, w, to, count);
    if (response.status == StepStatus::solved && response.change <= settings.tolerance &&
        !response.rate_converged) {
      response = respond(Effort::solution, from, tau, solver, w, to, count);
    }
    if (response.status != StepStatus::solved) {
      result.status = response.status;
      return result;
    }
    if (response.change <= settings.tolerance) {
      Kokkos::deep_copy(to.alpha_of_rate, response.alpha);
      unknowns_.finish(to);
      return result;
    }
    if (unknowns_.advance(to)) {
      if (!response.has_velocity) {
        solver.velocity(w);
      }
      solver.begin(equations_.setRightSide(to), w);
    }
  }
  result.status = StepStatus::fixed_point_failed;
  return result;
}
} // namespace asperity::dynamics
