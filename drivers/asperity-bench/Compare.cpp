#include "Compare.hpp"

#include "LinearReference.hpp"
#include "Meters.hpp"
#include "StepKinds.hpp"
#include "base/Errors.hpp"
#include "dynamics/FaultMotion.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <algorithm>
#include <optional>

using namespace asperity;

namespace
{
// A rate problem whose solution is known, see makeKnownProblem.
struct Known
{
  RCP<Vector> w, b, guess; // without the prescribed velocity
};

class Comparer
{
public:
  Comparer(scenario::Problem<3> const& problem, ParameterList const& deck,
           dynamics::RateUpdate const& update, dynamics::CoupledStep& step)
      : problem_(problem)
      , update_(update)
      , step_(step)
      , solvers_(problem.body, *problem.surface, update, step.clock(), problem.solver,
                 scenario::memoryBudget(deck.sublist("TNNMG")))
  {
  }

  // One more step of the level from `now`; before: an earlier state.
  void compare(dynamics::State const& now, dynamics::State const& before, int level,
               ComparedSteps& sum)
  {
    auto const& clock = step_.clock();
    const double ratio =
      static_cast<double>(clock.ticks(level)) / static_cast<double>(now.time - before.time);
    auto const guess = dynamics::blend(1 + ratio, now, before);
    auto end = guess.clone();
    dynamics::SolveCount count;
    step_.solve(now, level, end, count); // sets the step size up
    end = guess.clone();
    count = {};
    const CpuStopwatch watch;
    if (!step_.solve(now, level, end, count).solved()) {
      return; // too large a step; the control would halve it
    }
    sum.coupled_seconds += watch.seconds();
    sum.coupled_iterations += count.tnnmg_iterations;
    sum.coupled_cycles += count.v_cycles;
    ++sum.count;
    useLevel(level);
    auto const known = knownProblem(end, guess);
    const double error = solveRateProblem(known, end, level, sum);
    solveLinearProblem(known, error, sum);
  }

private:
  void useLevel(int level)
  {
    if (level_ != level) {
      level_ = level;
      const double tau = step_.clock().stepSize(level);
      Z_ = fem::combine(problem_.body.matrices, update_.mass_weight / tau, 1,
                        tau * update_.stiffness_weight, problem_.body.held);
      linear_.emplace(Z_, problem_.body);
    }
  }

  Known knownProblem(dynamics::State const& end, dynamics::State const& guess) const
  {
    auto const& body = problem_.body;
    auto const& surface = *problem_.surface;
    Known known = {body.vector(), body.vector(), body.vector()};
    auto const prescribed = body.vector();
    body.prescribed_velocity(step_.clock().seconds(end.time), *prescribed);
    known.w->update(1, *end.v, -1, *prescribed, 0);
    known.guess->update(1, *guess.v, -1, *prescribed, 0);
    body.clearHeld(*known.w);
    body.clearHeld(*known.guess);
    Z_->apply(*known.w, *known.b);
    const int num_nodes = surface.numNodes(), size = surface.numTangents();
    const friction::BlockView w("asperity::bench::w", num_nodes, size);
    const friction::BlockView gradient("asperity::bench::gradient", num_nodes, size);
    const friction::HessianView hessian("asperity::bench::hessian", num_nodes, size, size);
    const friction::FlagView kinked("asperity::bench::kinked", num_nodes);
    dynamics::gather(surface, *known.w, w);
    problem_.fault.friction().linearise(w, {end.alpha_of_rate, end.sigma_n}, gradient, hessian,
                                        kinked);
    {
      auto const values = known.b->getLocalViewHost(Tpetra::Access::ReadWrite);
      auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), gradient);
      for (int node = 0; node < num_nodes; ++node) {
        for (int k = 0; k < size; ++k) {
          values(surface[node].dofs[k], 0) += host(node, k);
        }
      }
    }
    body.clearHeld(*known.b);
    return known;
  }

  // The error of its answer in the energy norm.
  double solveRateProblem(Known const& known, dynamics::State const& end, int level,
                          ComparedSteps& sum)
  {
    auto& solver = solvers_.at(level);
    const dynamics::FrictionProblem nodal{problem_.fault.friction(),
                                          {end.alpha_of_rate, end.sigma_n}};
    auto const w = problem_.body.vector();
    const CpuStopwatch watch;
    solver.begin(*known.b, *known.guess);
    auto const result = solver.solve(nodal);
    solver.velocity(*w);
    sum.rate_seconds += watch.seconds();
    sum.rate_iterations += result.iterations;
    sum.rate_cycles += result.v_cycles;
    ASPERITY_REQUIRE(result.converged,
                     "A rate problem was not solved: its list TNNMG is at fault.");
    w->update(-1, *known.w, 1);
    const double error = energyNorm(*Z_, *w);
    sum.worst_error = std::max(sum.worst_error, error / energyNorm(*Z_, *known.w));
    return error;
  }

  void solveLinearProblem(Known const& known, double error, ComparedSteps& sum) const
  {
    Vector solution(*known.w, Teuchos::Copy), b(known.w->getMap()), x(known.w->getMap());
    solution.update(-1, *known.guess, 1);
    Z_->apply(solution, b);
    const int iterations = linear_->iterationsFor(b, solution, error);
    const CpuStopwatch watch;
    linear_->iterate(b, iterations, x);
    sum.linear_seconds += watch.seconds();
    sum.linear_cycles += iterations;
  }

  scenario::Problem<3> const& problem_;
  dynamics::RateUpdate update_;
  dynamics::CoupledStep& step_;
  dynamics::StepSolvers solvers_;
  int level_ = -1;
  RCP<const CrsMatrix> Z_;
  std::optional<LinearReference> linear_;
};
} // namespace

Comparison compareWithLinear(ParameterList const& deck, CompareOptions const& options,
                             RCP<const Communicator> const& communicator)
{
  ASPERITY_REQUIRE(communicator->getSize() == 1,
                   "asperity-bench compare runs on one rank: MueLu's coarse solver is wrong on "
                   "more.");
  auto const problem = scenario::makeProblem<3>(deck, communicator);
  ASPERITY_REQUIRE(!problem.reaction.reaction,
                   "asperity-bench compare takes no deck whose normal stress is coupled.");
  auto const& time = deck.sublist("Time Stepping");
  auto const update = scenario::makeRateUpdate(time, !scenario::quasiDynamic(deck.sublist("Bulk")));
  dynamics::CoupledStep step(problem.body, problem.fault, update, scenario::makeClock(time),
                             dynamics::CouplingSettings::from(deck.sublist("Coupling")),
                             problem.solver, scenario::memoryBudget(deck.sublist("TNNMG")));
  auto const control = scenario::makeStepControl(time, step);
  Comparer comparer(problem, deck, update, step);
  Comparison comparison;
  comparison.num_unknowns = problem.mesh.num_global_vertices * problem.components;
  const double crossing = crossingTime(deck, problem);
  auto state = problem.initial.clone();
  dynamics::SolveCount count;
  ProductMeter product(problem.body);
  for (int i = 0; i < options.num_steps; ++i) {
    auto const before = state.clone();
    auto const accepted = control->advance(state, count);
    product.sample();
    const double tau = step.clock().stepSize(accepted.level);
    comparer.compare(state, before, accepted.level,
                     tau < crossing ? comparison.inertial : comparison.quasi_static);
  }
  comparison.product_seconds = product.mean();
  return comparison;
}
