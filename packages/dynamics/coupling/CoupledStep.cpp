#include "dynamics/coupling/CoupledStep.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Agreement.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/parameters/Parameters.hpp"
#include "base/program/WorkTimers.hpp"
#include "dynamics/FaultMotion.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::dynamics
{
namespace
{
using friction::ConstNodeView;
using Nodes = Kokkos::RangePolicy<friction::ExecutionSpace>;

// mean := offset + weight mean, (num_nodes, T)
void meanVelocity(friction::ConstBlockView const& offset, double weight,
                  friction::BlockView const& mean)
{
  Kokkos::parallel_for(
    "asperity::dynamics::meanVelocity", Nodes(0, mean.extent_int(0)), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < mean.extent_int(1); ++k) {
        mean(node, k) = offset(node, k) + weight * mean(node, k);
      }
    });
}

// Half of what the change of the normal stress over the step does to the state: alpha moves by
// -(c / b) ln(sigma1 / sigma0) / 2 (Linker and Dieterich 1992).
void shiftByStress(ConstNodeView const& sensitivity, ConstNodeView const& before,
                   ConstNodeView const& after, ConstNodeView const& alpha,
                   friction::NodeView const& shifted)
{
  Kokkos::parallel_for(
    "asperity::dynamics::shiftByStress", Nodes(0, shifted.extent_int(0)), KOKKOS_LAMBDA(int node) {
      const double shift =
        sensitivity(node) == 0
          ? 0
          : sensitivity(node) / 2 * (math::log(after(node)) - math::log(before(node)));
      shifted(node) = alpha(node) - shift;
    });
}

// packed(2 num_nodes) := alpha, then sigma_n times what makes it comparable with alpha.
void pack(ConstNodeView const& alpha, ConstNodeView const& sigma_n, ConstNodeView const& per_pascal,
          friction::NodeView const& packed)
{
  const int size = alpha.extent_int(0);
  Kokkos::parallel_for(
    "asperity::dynamics::pack", Nodes(0, size), KOKKOS_LAMBDA(int node) {
      packed(node) = alpha(node);
      packed(size + node) = sigma_n(node) * per_pascal(node);
    });
}

void unpack(ConstNodeView const& packed, ConstNodeView const& per_pascal,
            friction::NodeView const& alpha, friction::NodeView const& sigma_n)
{
  const int size = alpha.extent_int(0);
  Kokkos::parallel_for(
    "asperity::dynamics::unpack", Nodes(0, size), KOKKOS_LAMBDA(int node) {
      alpha(node) = packed(node);
      sigma_n(node) = packed(size + node) / per_pascal(node);
    });
}
} // namespace

Teuchos::RCP<Teuchos::ParameterList> CouplingSettings::validParameters()
{
  const CouplingSettings defaults;
  return Declare()
    .real("Tolerance", defaults.tolerance, "-", Range::open(0, 1),
          "The fixed-point iteration of rate and state ends when alpha changes by at most this "
          "between two iterates, in the norm chosen.")
    .choice("Norm", "Root Mean Square", {"Root Mean Square", "Maximum"},
            "Selects how that change is measured over the fault. Maximum also responds to a "
            "nucleation much smaller than the fault, which has little weight in a mean.")
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
                         RateSolverSettings const& solver_settings, std::size_t budget_bytes,
                         ReactionSinceStart const& since_start)
    : body_(body)
    , fault_(fault)
    , update_(update)
    , clock_(clock)
    , settings_(settings)
    , stress_(body, fault, since_start)
    , solvers_(body, fault.surface(), update, clock, solver_settings, budget_bytes,
               stress_.coupled() ? since_start.reaction : nullptr)
    , acceleration_(fault.surface(), settings.anderson_depth)
    , forces_(body.noForces())
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
  const int size = surface().numNodes();
  if (stress_.coupled()) {
    sigma_next_ = friction::NodeView("asperity::dynamics::sigmaNext", size);
    unknowns_ = friction::NodeView("asperity::dynamics::unknowns", 2 * size);
    image_ = friction::NodeView("asperity::dynamics::image", 2 * size);
  }
  if (fault.laws().stress_sensitivity.extent(0) > 0) {
    shifted_ = friction::NodeView("asperity::dynamics::shifted", size);
  }
}

// Evaluates the expressions of the deck at the time t1. One of them may be nan on one rank alone;
// the error is thrown on all ranks.
void CoupledStep::evaluateLoads(double t0, double t1, State& to)
{
  ASPERITY_TIME_WORK("right sides of steps");
  onEveryRank(*surface().communicator(), [&] {
    if (fault_.normalStress().change() == NormalStressChange::fixed) {
      fault_.normalStress().at(t1, to.sigma_n);
      fault_.normalStress().raiseToFloor(to.sigma_n);
    }
    stress_.evaluate(t0, t1);
    body_.prescribed_velocity(t1, *prescribed_);
    requireRestBesideSliding(surface(), *prescribed_, body_.dofs->components(), t1);
    stickToPlates(surface(), *prescribed_);
    body_.load(t1, *b_);
  });
}

// b = l(t1) - M a_D - C v_D - K u_D on the free dofs, where v_D is the prescribed velocity, and u_D
// and a_D follow from it by the rate update: the rate problem is solved for w = v1 - v_D, which is
// zero at held dofs. Under back slip v_D is the motion of the plates at the free dofs of the fault,
// so that friction depends on w there (gatherSlip).
void CoupledStep::rightSide(State const& from, double tau)
{
  ASPERITY_TIME_WORK("right sides of steps");
  update_.predict(from, tau, *u_hat_, *a_hat_);
  update_.withVelocity(*prescribed_, *u_hat_, *a_hat_, tau, *work_u_, *work_a_);
  body_.computeForces(*work_u_, *prescribed_, *work_a_, forces_);
  forces_.subtractFrom(*b_);
  stress_.takeRightSide(*b_);
  body_.clearHeld(*b_);
}

CoupledResult CoupledStep::solve(State const& from, int level, State& to, SolveCount& count)
{
  auto const result = solveAtFault(from, level, to, count);
  if (result.solved()) {
    complete(from, level, to);
  }
  return result;
}

CoupledResult CoupledStep::solveAtFault(State const& from, int level, State& to, SolveCount& count)
{
  solved_level_.reset();
  const double tau = clock_.stepSize(level);
  to.time = from.time + clock_.ticks(level);
  evaluateLoads(clock_.seconds(from.time), clock_.seconds(to.time), to);
  stress_.begin(from, to.sigma_n);
  rightSide(from, tau);

  guess_->update(1, *to.v, -1, *prescribed_, 0);
  body_.clearHeld(*guess_);
  auto& solver = solvers_.at(level);
  solver.begin(*b_, *guess_);
  update_.meanVelocity(from, tau, *prescribed_, surface().dofs(), *work_u_);
  gatherSlip(surface(), *work_u_, mean_offset_);

  auto const result = iterate(from, tau, solver, to, count);
  ++count.coupled_steps;
  if (!result.solved()) {
    ++count.failures;
    return result;
  }
  solver.knownVelocity(*guess_);
  to.v->update(1, *guess_, 1, *prescribed_, 0);
  solved_level_ = level;
  return result;
}

void CoupledStep::complete(State const& from, int level, State& to)
{
  ASPERITY_ASSERT(solved_level_ == level);
  solvers_.at(level).velocity(*to.v);
  to.v->update(1, *prescribed_, 1);
  update_.complete(from, *u_hat_, *a_hat_, clock_.stepSize(level), to);
  solved_level_.reset();
}

// |c (u1 - u0)_t / tau + Vp| at the fault nodes.
void CoupledStep::meanSlipRate(RateSolver& solver)
{
  solver.faultVelocity(mean_);
  meanVelocity(mean_offset_, update_.stiffness_weight, mean_);
  slipRate(surface(), mean_, V_);
}

// Updates the state with the solver's present velocity. False if the state law fails at a node.
bool CoupledStep::updateState(State const& from, double tau, RateSolver& solver, State const& to)
{
  ASPERITY_TIME_WORK("state updates");
  meanSlipRate(solver);
  const bool moved_by_stress = shifted_.extent(0) > 0;
  if (moved_by_stress) {
    shiftByStress(fault_.laws().stress_sensitivity, from.sigma_n, to.sigma_n, from.alpha, shifted_);
  }
  const int failures =
    fault_.state().flow(V_, tau, moved_by_stress ? shifted_ : from.alpha, alpha_next_);
  if (moved_by_stress) {
    shiftByStress(fault_.laws().stress_sensitivity, from.sigma_n, to.sigma_n, alpha_next_,
                  alpha_next_);
  }
  return sumOverRanks(failures, *surface().communicator()) == 0;
}

// The change of alpha and, if it is coupled, of the normal stress from the iterate to its image.
double CoupledStep::changeOf(State const& to) const
{
  const double of_alpha = distance(surface(), alpha_next_, to.alpha, settings_.norm);
  if (!stress_.coupled()) {
    return of_alpha;
  }
  const int size = surface().numNodes();
  const auto part = std::make_pair(size, 2 * size);
  const double of_stress = distance(surface(), Kokkos::subview(image_, part),
                                    Kokkos::subview(unknowns_, part), settings_.norm);
  return std::isfinite(of_stress) ? std::max(of_alpha, of_stress) : of_stress;
}

// The next iterate in `to`.
void CoupledStep::accelerate(State& to)
{
  if (!stress_.coupled()) {
    acceleration_.advance(to.alpha, alpha_next_);
    return;
  }
  acceleration_.advance(unknowns_, image_);
  unpack(unknowns_, stress_.perPascal(), to.alpha, to.sigma_n);
  fault_.normalStress().raiseToFloor(to.sigma_n); // extrapolation may pass it
}

// Packs alpha and the normal stress, and their images for the solver's velocity, if coupled.
void CoupledStep::respond(RateSolver const& solver, State const& to)
{
  if (!stress_.coupled()) {
    return;
  }
  stress_.respond(solver, sigma_next_);
  pack(to.alpha, to.sigma_n, stress_.perPascal(), unknowns_);
  pack(alpha_next_, sigma_next_, stress_.perPascal(), image_);
}

// Alternates one iteration of TNNMG and one update of the state: both reduce the error by similar
// factors, and more iterations for a state that still changes would be wasted. When the state has
// converged, the rate problem is solved with it.
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
    const bool updated = updateState(from, tau, solver, to);
    respond(solver, to);
    const double change = changeOf(to);
    if (!updated || !std::isfinite(change)) {
      Kokkos::deep_copy(to.alpha, alpha_next_); // a value that is not finite can be found there
      if (stress_.coupled()) {
        Kokkos::deep_copy(to.sigma_n, sigma_next_);
      }
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
      accelerate(to);
      last_change = change;
    }
  }
  result.status = StepStatus::fixed_point_failed;
  return result;
}
} // namespace asperity::dynamics
