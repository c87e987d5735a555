#include "steps/Steps.hpp"

#include "base/parallel/Reductions.hpp"
#include "measuring/CountedProducts.hpp"
#include "measuring/Meters.hpp"
#include "stretch/Stretch.hpp"

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
  Stretch stretch(deck, communicator);
  auto const& solvers = stretch.step().solvers();
  StretchSample sample;
  sample.num_unknowns = stretch.numUnknowns();
  ProductMeter product(stretch.problem().body);
  for (int i = 0; i < options.num_steps; ++i) {
    auto const before = stretch.count();
    auto const messages_before = messagesSoFar();
    const double setup_before = solvers.setupSeconds();
    const CountedProducts products;
    const Stopwatch watch;
    const CpuStopwatch cpu;
    const double tau = stretch.step().clock().stepSize(stretch.advance());
    const double seconds = cpu.seconds();
    addDifference(messagesSoFar(), messages_before, sample.messages);
    // Set-ups are timed in wall time, which is converted to CPU time here.
    const double setup = (solvers.setupSeconds() - setup_before) * seconds / watch.seconds();
    auto& kind = stretch.isInertial(tau) ? sample.inertial : sample.quasi_static;
    add(kind, tau, stretch.count().since(before));
    kind.products += products.count();
    kind.seconds += seconds - setup;
    kind.setup_seconds += setup;
    product.sample();
  }
  sample.messages = largestOfRanks(sample.messages, *communicator);
  sample.product_seconds = product.mean();
  sample.setups = solvers.setups();
  sample.peak_bytes = sumOverRanks(peakBytes(), *communicator);
  return sample;
}
