#include "Steps.hpp"

#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"
#include "scenario/report/ModelSize.hpp"
#include "scenario/run/Evolution.hpp"
#include "scenario/setup/mesh/MeshSetup.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <ctime>
#include <iomanip>
#include <sstream>

namespace asperity::bench
{
namespace
{
// CPU time of this process [s]: unlike wall time, it hardly sees other work on the machine.
double cpuSeconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Cost
{
  int num_ranks = 1;
  double num_unknowns = 0;
  int num_steps = 0;                // accepted
  double smallest = 0, largest = 0; // step size tau [s]
  dynamics::SolveCount count;       // with the steps that were tried on the way
  double seconds = 0;               // CPU time of all threads of this rank, without set-up
  double wall_seconds = 0;          // likewise
  int setups = 0;                   // of step sizes
  double setup_seconds = 0;         // likewise
  double product_seconds = 0;       // of a product with K: CPU time, the mean over the steps
  double peak_bytes = 0;            // of all ranks
};

// Products with K are timed between the steps, where the caches are as the steps leave them.
class ProductMeter
{
public:
  explicit ProductMeter(dynamics::Body const& body)
      : K_(*body.matrices.stiffness)
      , x_(body.vector())
      , y_(body.vector())
  {
    x_->randomize();
  }

  void sample()
  {
    K_.apply(*x_, *y_); // brings the matrix into the caches
    const double start = cpuSeconds();
    for (int i = 0; i < 3; ++i) {
      K_.apply(*x_, *y_);
    }
    seconds_ += cpuSeconds() - start;
    count_ += 3;
  }

  double mean() const { return seconds_ / count_; }

private:
  CrsMatrix const& K_;
  RCP<Vector> x_, y_;
  double seconds_ = 0;
  int count_ = 0;
};

template <int Dim>
Cost costOf(ParameterList const& deck, int num_steps, RCP<const Communicator> const& communicator)
{
  auto const problem = scenario::makeProblem<Dim>(deck, communicator);
  scenario::Evolution<Dim> evolution(problem, deck, {});
  Cost cost;
  cost.num_ranks = communicator->getSize();
  cost.num_unknowns =
    static_cast<double>(problem.mesh().num_global_vertices) * problem.components();
  ProductMeter product(problem.model.body);
  for (; cost.num_steps < num_steps && !evolution.atEnd(); ++cost.num_steps) {
    const double start = cpuSeconds(), wall_start = wallSeconds();
    evolution.advance();
    cost.seconds += cpuSeconds() - start;
    cost.wall_seconds += wallSeconds() - wall_start;
    const double tau = evolution.clock().stepSize(evolution.view().step.level);
    cost.smallest = cost.num_steps == 0 ? tau : std::min(cost.smallest, tau);
    cost.largest = std::max(cost.largest, tau);
    product.sample();
  }
  auto const summary = evolution.summary();
  cost.count = summary.count;
  cost.setups = summary.setups;
  // from wall to CPU time
  cost.setup_seconds = summary.setup_seconds * cost.seconds / cost.wall_seconds;
  cost.seconds -= cost.setup_seconds;
  cost.wall_seconds -= summary.setup_seconds;
  cost.product_seconds = product.mean();
  cost.peak_bytes = sumOverRanks(scenario::peakBytes(), *communicator);
  return cost;
}

std::string tableOf(Cost const& cost)
{
  const auto each = static_cast<double>(cost.count.coupled_steps);
  const auto perStep = [&](std::int64_t number) { return static_cast<double>(number) / each; };
  std::ostringstream out;
  out << "\n"
      << std::setprecision(12) << cost.num_unknowns << std::setprecision(3) << " unknowns, "
      << cost.num_ranks << (cost.num_ranks > 1 ? " ranks" : " rank") << "; product with K "
      << 1e3 * cost.product_seconds << " ms; " << cost.setups
      << " set-ups of step sizes; peak memory " << cost.peak_bytes / 1e6 << " MB, "
      << cost.peak_bytes / cost.num_unknowns / 1e3
      << " kB per unknown\n\n"
         "A coupled step takes "
      << 1e3 * cost.wall_seconds / each
      << " ms of wall time, without set-up. For each of them, CPU times of all threads in products "
         "with K:\n\n"
         "| tau [s] | accepted | coupled | rate problems | TNNMG | V-cycles | time | set-up, all | "
         "energy increases |\n|---|---|---|---|---|---|---|---|---|\n| "
      << cost.smallest << " to " << cost.largest << " | " << cost.num_steps << " | "
      << cost.count.coupled_steps << " | " << perStep(cost.count.rate_problems) << " | "
      << perStep(cost.count.tnnmg_iterations) << " | " << perStep(cost.count.v_cycles) << " | "
      << cost.seconds / each / cost.product_seconds << " | "
      << cost.setup_seconds / cost.product_seconds << " | " << cost.count.energy_increases
      << " |\n\n";
  return out.str();
}

std::string jsonOf(Cost const& cost)
{
  std::ostringstream out;
  out << std::setprecision(12) << "{\"ranks\": " << cost.num_ranks
      << ", \"unknowns\": " << cost.num_unknowns << ", \"accepted\": " << cost.num_steps;
  for (auto const& member : dynamics::SolveCount::members()) {
    out << ", \"" << member.name << "\": " << cost.count.*member.value;
  }
  out << ", \"seconds\": " << cost.seconds << ", \"wall_seconds\": " << cost.wall_seconds
      << ", \"setups\": " << cost.setups << ", \"setup_seconds\": " << cost.setup_seconds
      << ", \"product_seconds\": " << cost.product_seconds
      << ", \"peak_bytes\": " << cost.peak_bytes << "}\n";
  return out.str();
}
} // namespace

Report measureSteps(ParameterList const& deck, int num_steps,
                    RCP<const Communicator> const& communicator)
{
  auto const cost = scenario::meshDimension(deck.sublist("Mesh"), *communicator) == 2
                      ? costOf<2>(deck, num_steps, communicator)
                      : costOf<3>(deck, num_steps, communicator);
  return {tableOf(cost) + tableOfWork(*communicator), jsonOf(cost)};
}
} // namespace asperity::bench
