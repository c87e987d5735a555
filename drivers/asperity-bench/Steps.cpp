#include "Steps.hpp"

#include "Meters.hpp"
#include "StepKinds.hpp"
#include "base/parallel/Reductions.hpp"
#include "scenario/Problem.hpp"
#include "scenario/setup/BulkSetup.hpp"
#include "scenario/setup/SolverSetup.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <algorithm>

using namespace asperity;

namespace
{
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
    auto const messages_before = messagesSoFar();
    const double setup_before = step.solvers().setupSeconds();
    const Stopwatch watch;
    const CpuStopwatch cpu;
    auto const accepted = control->advance(state, count);
    const double seconds = cpu.seconds();
    addDifference(messagesSoFar(), messages_before, sample.messages);
    // Set-ups are timed by the clock on the wall.
    const double setup = (step.solvers().setupSeconds() - setup_before) * seconds / watch.seconds();
    product.sample();
    const double tau = step.clock().stepSize(accepted.level);
    auto& kind = tau < crossing ? sample.inertial : sample.quasi_static;
    add(kind, tau, count.since(before));
    kind.seconds += seconds - setup;
    kind.setup_seconds += setup;
  }
  sample.messages = largestOfRanks(sample.messages, *communicator);
  sample.product_seconds = product.mean();
  sample.setups = step.solvers().setups();
  sample.peak_bytes = sumOverRanks(peakBytes(), *communicator);
  return sample;
}
