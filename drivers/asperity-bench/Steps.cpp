#include "Steps.hpp"

#include "Meters.hpp"
#include "base/parallel/Reductions.hpp"
#include "scenario/Problem.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace asperity;

namespace
{
// The longest side of the box around the mesh [m].
double longestSide(Mesh<3> const& mesh, Communicator const& communicator)
{
  double longest = 0;
  for (int d = 0; d < 3; ++d) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (auto const& x : mesh.vertices) {
      low = std::min(low, x[d]);
      high = std::max(high, x[d]);
    }
    longest =
      std::max(longest, maxOverRanks(high, communicator) + maxOverRanks(-low, communicator));
  }
  return longest;
}

// Steps below this are inertial [s]; zero without a mass.
double crossingTime(ParameterList const& deck, scenario::Problem<3> const& problem)
{
  if (problem.body.matrices.is_massless || scenario::quasiDynamic(deck.sublist("Bulk"))) {
    return 0;
  }
  double slowness = 0; // of the slowest shear wave [s/m]
  for (auto const& m : scenario::makeMaterials<3>(deck.sublist("Bulk"), problem.mesh)) {
    slowness = std::max(slowness, std::sqrt(m.density / m.shear_modulus));
  }
  return longestSide(problem.mesh, *problem.communicator) *
         maxOverRanks(slowness, *problem.communicator);
}

// Products with K, timed between the steps of the stretch.
class ProductMeter
{
public:
  explicit ProductMeter(dynamics::Body const& body)
      : body_(body)
      , x_(body.vector())
      , y_(body.vector())
  {
    x_->randomize();
  }
  void sample()
  {
    body_.matrices.stiffness->apply(*x_, *y_); // brings the matrix into the caches
    const CpuStopwatch watch;
    for (int i = 0; i < 3; ++i) {
      body_.matrices.stiffness->apply(*x_, *y_);
    }
    seconds_ += watch.seconds();
    count_ += 3;
  }
  double mean() const { return seconds_ / count_; }

private:
  dynamics::Body const& body_;
  RCP<Vector> x_, y_;
  double seconds_ = 0;
  int count_ = 0;
};

void add(StepsSample& sample, double tau, dynamics::SolveCount const& count)
{
  sample.smallest = sample.accepted == 0 ? tau : std::min(sample.smallest, tau);
  sample.largest = std::max(sample.largest, tau);
  ++sample.accepted;
  for (auto const& member : dynamics::SolveCount::members()) {
    sample.count.*member.value += count.*member.value;
  }
}
} // namespace

StretchSample measureSteps(ParameterList const& deck, StepsOptions const& options,
                           RCP<const Communicator> const& communicator)
{
  auto const problem = scenario::makeProblem<3>(deck, communicator);
  auto const& time = deck.sublist("Time Stepping");
  auto const update = scenario::makeRateUpdate(time, !scenario::quasiDynamic(deck.sublist("Bulk")));
  dynamics::CoupledStep step(problem.body, problem.fault, update, scenario::makeClock(time),
                             dynamics::CouplingSettings::from(deck.sublist("Coupling")),
                             problem.solver, scenario::memoryBudget(deck.sublist("TNNMG")),
                             problem.reaction);
  auto const control = scenario::makeStepControl(time, step);
  StretchSample sample;
  sample.num_unknowns = problem.mesh.num_global_vertices * problem.components;
  const double crossing = crossingTime(deck, problem);
  auto state = problem.initial.clone();
  dynamics::SolveCount count;
  ProductMeter product(problem.body);
  for (int i = 0; i < options.num_steps; ++i) {
    auto const before = count;
    const double setup_before = step.solvers().setupSeconds();
    const Stopwatch watch;
    const CpuStopwatch cpu;
    auto const accepted = control->advance(state, count);
    const double seconds = cpu.seconds();
    // Set-ups are timed by the clock on the wall.
    const double setup = (step.solvers().setupSeconds() - setup_before) * seconds / watch.seconds();
    product.sample();
    const double tau = step.clock().stepSize(accepted.level);
    auto& kind = tau < crossing ? sample.inertial : sample.quasi_static;
    add(kind, tau, count.since(before));
    kind.seconds += seconds - setup;
    kind.setup_seconds += setup;
  }
  sample.product_seconds = product.mean();
  sample.setups = step.solvers().setups();
  sample.peak_bytes = sumOverRanks(peakBytes(), *communicator);
  return sample;
}
