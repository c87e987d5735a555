#include "Kernels.hpp"

#include "BenchKernels.hpp"

#include "base/Errors.hpp"
#include "base/Views.hpp"
#include "base/parallel/Reductions.hpp"
#include "dynamics/RateUpdate.hpp"
#include "dynamics/rate/SharedMultigrid.hpp"
#include "fem/BodyMatrices.hpp"
#include "multigrid/Cycle.hpp"
#include "multigrid/NodeKernels.hpp"
#include "multigrid/Smoother.hpp"
#include "portability/Renamed.hpp"
#include "scenario/problem/Problem.hpp"
#include "scenario/setup/mesh/MeshSetup.hpp"
#include "tnnmg/SparseRateMatrix.hpp"
#include "tnnmg/hierarchy/MultigridHierarchy.hpp"

#include <Kokkos_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace asperity::bench
{
namespace
{
constexpr double real = sizeof(double), single = sizeof(float), index = sizeof(int);

// A kernel on all ranks together.
struct Kernel
{
  std::string name;
  double bytes;   // that it has to move at least
  double seconds; // the least of several runs, of the slowest rank

  double rate() const { return bytes / seconds; }
};

// prepare() comes before each run and is not timed. Collective.
template <class Prepare, class Run>
double leastSeconds(Communicator const& communicator, Prepare const& prepare, Run const& run)
{
  constexpr double long_enough = 0.5; // s, of all runs
  constexpr int least_runs = 5, most_runs = 1000;
  double least = std::numeric_limits<double>::infinity();
  double total = 0;
  for (int i = 0; i < least_runs || (total < long_enough && i < most_runs); ++i) {
    prepare();
    Kokkos::fence();
    communicator.barrier();
    const double start = wallSeconds();
    run();
    Kokkos::fence();
    const double seconds = maxOverRanks(wallSeconds() - start, communicator);
    least = std::min(least, seconds);
    total += seconds;
  }
  return least;
}

Kernel triad(Communicator const& communicator)
{
  // of all ranks together 134 MB each, if there are no more than sixteen
  const int size = std::max(1 << 20, (1 << 24) / communicator.getSize());
  const NodeView a("asperity::bench::a", size), b("asperity::bench::b", size);
  const NodeView c("asperity::bench::c", size);
  Kokkos::deep_copy(b, 1.);
  Kokkos::deep_copy(c, 2.);
  const double seconds = leastSeconds(
    communicator, [] {}, [&] { addTriad(a, b, c); });
  return {"STREAM triad", sumOverRanks(3 * real * size, communicator), seconds};
}

class Meter
{
public:
  explicit Meter(Communicator const& communicator)
      : communicator_(communicator)
      , kernels_({triad(communicator)})
  {
  }

  // bytes: of this rank. Collective.
  template <class Prepare, class Run>
  void measure(std::string const& name, double bytes, Prepare const& prepare, Run const& run)
  {
    kernels_.push_back(
      {name, sumOverRanks(bytes, communicator_), leastSeconds(communicator_, prepare, run)});
  }
  template <class Run>
  void measure(std::string const& name, double bytes, Run const& run)
  {
    measure(
      name, bytes, [] {}, run);
  }

  std::vector<Kernel> const& kernels() const { return kernels_; } // the triad first

private:
  Communicator const& communicator_;
  std::vector<Kernel> kernels_;
};

// What a pass over all blocks reads, without vectors.
double bytesOfBlocks(multigrid::DeviceGraph const& graph)
{
  return index * static_cast<double>(graph.num_rows + graph.numCouplings()) +
         single * graph.numCouplings() * graph.blockSize();
}

// A sweep reads all blocks but those of the diagonal, whose inverses stand apart, and goes over
// four vectors.
double bytesOfSweep(multigrid::Level const& level)
{
  auto const& graph = level.graph;
  return bytesOfBlocks(graph) + index * graph.num_rows +
         4 * single * static_cast<double>(graph.rows());
}

// passes: over the fine vector, one to read it and one to write it.
double bytesOfTransfer(multigrid::Level const& level, int passes)
{
  auto const& graph = level.prolongation;
  return bytesOfBlocks(graph) +
         single * static_cast<double>(passes * graph.rows() + graph.columnsWithGhosts());
}

double bytesOfRestriction(multigrid::Level const& level)
{
  return bytesOfTransfer(level, 1) + static_cast<double>(level.restriction.bytes());
}

double bytesOfProlongation(multigrid::Level const& level) { return bytesOfTransfer(level, 2); }

double bytesOfCycle(multigrid::Hierarchy const& hierarchy)
{
  auto const& levels = hierarchy.levels();
  auto const& coarsest = hierarchy.coarsest();
  const bool has_factor = coarsest.sum_shared || levels.back().graph.rows() > 0;
  double sum = has_factor ? real * coarsest.num_rows * coarsest.num_rows : 0; // both halves
  for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
    sum +=
      2 * bytesOfSweep(levels[l]) + bytesOfRestriction(levels[l]) + bytesOfProlongation(levels[l]);
  }
  return sum;
}

multigrid::NodeVector ones(std::size_t size)
{
  const auto result = multigrid::makeNumbers(size);
  Kokkos::deep_copy(result, 1.f);
  return result;
}

void measureProducts(Meter& meter, dynamics::Body const& body)
{
  auto const& K = *body.matrices.stiffness; // that never relaxes, with as many entries as any
  const auto x = body.vector(), y = body.vector();
  x->randomize();
  const auto rows = static_cast<double>(numLocalRows(K));
  meter.measure("product with K, rows in double",
                static_cast<double>(numLocalEntries(K)) * (real + sizeof(LocalOrdinal)) +
                  rows * (sizeof(std::size_t) + real) +
                  real * static_cast<double>(numLocalColumns(K)),
                [&] { K.apply(*x, *y); });
}

void measureMultigrid(Meter& meter, dynamics::Body const& body, fem::Weights const& weights,
                      CrsMatrix const& Z, dynamics::SharedMultigrid const& shared)
{
  auto const& hierarchy = shared.terms().hierarchy();
  auto const& level = hierarchy.levels().front();
  auto const& flags = body.held.flags();
  const std::vector<char> held(flags.begin(), flags.begin() + body.numOwnedDofs());
  auto const Z_blocks = hierarchy.finestBlocks(Z);
  auto const A = hierarchy.shared()->inOrder(Z_blocks);
  const auto b = ones(level.graph.rows()), x = ones(level.graph.columnsWithGhosts());
  const auto y = ones(level.graph.rows()), residual = ones(level.graph.rows());
  meter.measure("product with Z, blocks in single",
                bytesOfBlocks(level.graph) + single * static_cast<double>(3 * b.extent(0)),
                [&] { multigrid::multiplyAdd(level.graph, level.schedule, A, x, y); });
  // Zero, so that no sweep overflows.
  const multigrid::LevelMatrix matrix = {
    level,
    A,
    multigrid::makeNumbers(level.hasJacobiPart() ? level.graph.rows() : 0),
    multigrid::makeNumbers(level.graph.rows() * level.graph.row_size),
    {},
    hierarchy.shared()->coarsest().sum};
  const auto smoother =
    multigrid::SmootherRegistry::instance().at(multigrid::Cycle::usual_smoother).make();
  meter.measure("forward sweep and residual", bytesOfSweep(level),
                [&] { smoother->presmooth(matrix, b, x, residual); });
  if (hierarchy.levels().size() > 1) {
    const auto coarse = ones(level.prolongation.columnsWithGhosts());
    std::vector<multigrid::NodeVector> parts;
    meter.measure("restriction", bytesOfRestriction(level), [&] {
      level.restriction.multiply(level.prolongation, level.schedule, level.P, residual, coarse,
                                 parts);
    });
    meter.measure("prolongation", bytesOfProlongation(level), [&] {
      multigrid::multiplyAdd(level.prolongation, level.schedule, level.P, coarse, x);
    });
  }
  multigrid::Cycle cycle(hierarchy.shared(), shared.weights(weights), Z_blocks, held,
                         {}); // nothing is added
  ASPERITY_REQUIRE(cycle.setup({}, {}),
                   "The matrix of a step is not positive definite: nothing holds the body.");
  meter.measure("V-cycle", bytesOfCycle(*hierarchy.shared()), [&] { cycle.run(b, false); });
}

// Block problems of the nodes that slide, whose solution is 1 um/s, from a guess of 1 nm/s; and a
// second of the state there.
void measureFriction(Meter& meter, dynamics::Fault const& fault, dynamics::State const& state,
                     RCP<const CrsMatrix> const& Z)
{
  auto const& surface = fault.surface();
  const int num_nodes = surface.numNodes(), T = surface.numTangents();
  const tnnmg::SparseRateMatrix matrix(Z, dynamics::nodesOf(surface));
  const BlockView v("asperity::bench::v", num_nodes, T), r("asperity::bench::r", num_nodes, T);
  const HessianView hessian("asperity::bench::hessian", num_nodes, T, T);
  const FlagView kinked("asperity::bench::kinked", num_nodes);
  auto const at = fault.given(state);
  constexpr double solution = 1e-6, guess = 1e-9; // m/s
  const auto alongFirst = [&](double speed) {
    Kokkos::deep_copy(v, 0.);
    Kokkos::deep_copy(Kokkos::subview(v, Kokkos::ALL(), 0), speed);
  };
  alongFirst(solution);
  fault.friction().linearise(v, at, r, hessian, kinked);
  addForce(matrix.curvature(), solution, r);
  std::vector<int> sliding;
  for (int node = 0; node < num_nodes; ++node) {
    if (surface.slides(node)) {
      sliding.push_back(node);
    }
  }
  const IndexView nodes = toDevice(sliding, "asperity::bench::nodes");
  int failed = 0;
  const double values = 5 + fault.laws().friction_parameters.extent_int(0); // at, weight, ...
  meter.measure(
    "friction, block problems",
    static_cast<double>(sliding.size()) * (index + real * (1 + 3 * T + values)),
    [&] { alongFirst(guess); },
    [&] { failed = fault.friction().minimise(nodes, matrix.curvature(), r, at, v); });
  ASPERITY_REQUIRE(sumOverRanks(failed, *surface.communicator()) == 0,
                   "Friction has no solution at some nodes for a slip rate of 1e-6 m/s.");
  const NodeView V("asperity::bench::V", num_nodes), alpha("asperity::bench::alpha", num_nodes);
  Kokkos::deep_copy(V, solution);
  meter.measure("friction, state update",
                num_nodes * real * (3 + fault.laws().state_parameters.extent_int(0)),
                [&] { fault.state().flow(V, 1, state.alpha, alpha); });
}

template <int Dim>
std::vector<Kernel> kernelsOf(ParameterList const& deck,
                              RCP<const Communicator> const& communicator)
{
  const auto problem = scenario::makeProblem<Dim>(deck, communicator);
  auto const& body = problem.model.body;
  const double tau = deck.sublist("Time Stepping").template get<double>("Largest Step");
  auto const weights = dynamics::RateUpdate::backwardEuler().weights(tau, body.matrices);
  const RCP<const CrsMatrix> Z = fem::combine(body.matrices, weights, body.held);
  Meter meter(*communicator);
  measureProducts(meter, body);
  measureMultigrid(meter, body, weights, *Z,
                   dynamics::SharedMultigrid(body, problem.surface(), problem.solver.multigrid));
  measureFriction(meter, problem.model.fault, problem.model.initial, Z);
  return meter.kernels();
}

std::string tableOf(std::vector<Kernel> const& kernels)
{
  std::ostringstream out;
  out << "\nIn the execution space " << ExecutionSpace::name() << ":\n\n"
      << "| kernel | MB | ms | GB/s | of the triad |\n|---|---|---|---|---|\n"
      << std::setprecision(3);
  for (auto const& kernel : kernels) {
    out << "| " << kernel.name << " | " << kernel.bytes / 1e6 << " | " << 1e3 * kernel.seconds
        << " | " << kernel.rate() / 1e9 << " | " << kernel.rate() / kernels.front().rate()
        << " |\n";
  }
  return out.str();
}

std::string jsonOf(std::vector<Kernel> const& kernels)
{
  std::ostringstream out;
  char const* before = "[";
  for (auto const& kernel : kernels) {
    out << before << "{\"kernel\": \"" << kernel.name << "\", \"space\": \""
        << ExecutionSpace::name() << "\", \"bytes\": " << std::setprecision(12) << kernel.bytes
        << ", \"seconds\": " << kernel.seconds
        << ", \"share_of_triad\": " << kernel.rate() / kernels.front().rate() << '}';
    before = ",\n ";
  }
  out << "]\n";
  return out.str();
}
} // namespace

Report measureKernels(ParameterList const& deck, RCP<const Communicator> const& communicator)
{
  auto const kernels = scenario::meshDimension(deck.sublist("Mesh"), *communicator) == 2
                         ? kernelsOf<2>(deck, communicator)
                         : kernelsOf<3>(deck, communicator);
  return {tableOf(kernels), jsonOf(kernels)};
}
} // namespace asperity::bench
