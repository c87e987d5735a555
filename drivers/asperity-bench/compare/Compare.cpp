#include "compare/Compare.hpp"

#include "base/Errors.hpp"
#include "compare/LinearReference.hpp"
#include "measuring/Meters.hpp"
#include "rate_problems/FrictionForces.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "stretch/Stretch.hpp"

#include <algorithm>
#include <optional>

using namespace asperity;

namespace
{
// A rate problem whose solution w is known, with b = Z w + gradient of friction at w.
struct Known
{
  RCP<Vector> w, b, guess; // without the prescribed velocity
};

class Comparer
{
public:
  Comparer(Stretch& stretch, ParameterList const& deck)
      : problem_(stretch.problem())
      , update_(stretch.update())
      , step_(stretch.step())
      , solvers_(problem_.body, *problem_.surface, update_, step_.clock(), problem_.solver,
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
    auto const guess = dynamics::blend({1 + ratio, now, before});
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
    Known known = {body.vector(), body.vector(), body.vector()};
    auto const prescribed = body.vector();
    body.prescribed_velocity(step_.clock().seconds(end.time), *prescribed);
    known.w->update(1, *end.v, -1, *prescribed, 0);
    known.guess->update(1, *guess.v, -1, *prescribed, 0);
    body.clearHeld(*known.w);
    body.clearHeld(*known.guess);
    Z_->apply(*known.w, *known.b);
    addFrictionForces(*problem_.surface,
                      {problem_.fault.friction(), {end.alpha_of_rate, end.sigma_n}}, *known.w,
                      *known.b);
    body.clearHeld(*known.b);
    return known;
  }

  // Returns the error of the computed solution in the energy norm.
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
                     "A rate problem was not solved. Check the list TNNMG of the deck.");
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
                   "asperity-bench compare runs on one rank: MueLu's coarse solver gives wrong "
                   "results on more.");
  Stretch stretch(deck, communicator);
  ASPERITY_REQUIRE(!stretch.problem().reaction.reaction,
                   "asperity-bench compare needs Friction / Normal Stress Change = Fixed.");
  Comparer comparer(stretch, deck);
  Comparison comparison;
  comparison.num_unknowns = stretch.numUnknowns();
  ProductMeter product(stretch.problem().body);
  for (int i = 0; i < options.num_steps; ++i) {
    auto const before = stretch.state().clone();
    const int level = stretch.advance();
    product.sample();
    comparer.compare(stretch.state(), before, level,
                     stretch.isInertial(stretch.step().clock().stepSize(level))
                       ? comparison.inertial
                       : comparison.quasi_static);
  }
  comparison.product_seconds = product.mean();
  return comparison;
}
