#include "stiffness/FaultStiffness.hpp"

#include "base/Errors.hpp"
#include "dynamics/NormalReaction.hpp"
#include "fem/BodyMatrices.hpp"
#include "scenario/Problem.hpp"
#include "scenario/setup/MeshSetup.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

using namespace asperity;

namespace
{
using Problem = scenario::Problem<2>;

// The nodes where friction decides on slip, from the highest one on.
std::vector<int> slidingNodes(fem::FaultSurface const& surface)
{
  std::vector<int> nodes;
  for (int node = 0; node < surface.numNodes(); ++node) {
    if (surface.slides(node)) {
      nodes.push_back(node);
    }
  }
  ASPERITY_REQUIRE(nodes.size() > 1,
                   "Fewer than two nodes of the fault slide with friction. Refine the mesh.");
  const auto isAbove = [&](int a, int b) {
    auto const& x = surface[a].place;
    auto const& y = surface[b].place;
    return x[1] != y[1] ? x[1] > y[1] : x[0] < y[0];
  };
  std::sort(nodes.begin(), nodes.end(), isAbove);
  return nodes;
}

double distance(fem::FaultNode const& a, fem::FaultNode const& b)
{
  return std::hypot(a.place[0] - b.place[0], a.place[1] - b.place[1]);
}

// (n, n) row by row: the compression [Pa] at a node for unit slip at another one.
std::vector<double> compressionOf(Problem const& problem, std::vector<int> const& nodes,
                                  tnnmg::SchurComplement const& equilibrium)
{
  auto const& body = problem.body;
  const std::size_t n = nodes.size();
  auto const zero = body.vector(), u = body.vector();
  Vector slip(equilibrium.map());
  auto const no_forces = equilibrium.condense(*zero);
  const friction::NodeView R("asperity::bench::R", problem.surface->numNodes());
  std::vector<double> result(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    slip.putScalar(0);
    slip.replaceLocalValue(static_cast<int>(j), 1 / problem.surface->slipFactor());
    no_forces.expand(slip, *u);
    problem.reaction.reaction->compression(*zero, *u, *zero, *zero, R);
    auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), R);
    for (std::size_t i = 0; i < n; ++i) {
      result[i * n + j] = host(nodes[i]);
    }
  }
  return result;
}
} // namespace

FaultStiffness stiffnessOfFault(ParameterList const& deck,
                                RCP<const Communicator> const& communicator)
{
  ASPERITY_REQUIRE(communicator->getSize() == 1, "asperity-bench stiffness runs on one rank.");
  ASPERITY_REQUIRE(scenario::meshDimension(deck.sublist("Mesh"), *communicator) == 2,
                   "asperity-bench stiffness needs a two-dimensional deck.");
  auto const problem = scenario::makeProblem<2>(deck, communicator);
  auto const& surface = *problem.surface;
  ASPERITY_REQUIRE(surface.otherSide().deforming_sides == 2,
                   "asperity-bench stiffness compares with a fault whose two sides deform; this "
                   "deck's lies on a rigid foundation.");
  auto const nodes = slidingNodes(surface);
  std::vector<int> dofs;
  dofs.reserve(nodes.size());
  for (int node : nodes) {
    dofs.push_back(surface[node].dofs[0]);
  }
  const tnnmg::SchurComplement equilibrium(
    *fem::combine(problem.body.matrices, 0, 0, 1, problem.body.held), dofs);

  FaultStiffness result;
  auto const S = toHost(equilibrium.matrix());
  const auto n = nodes.size();
  result.traction.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    auto const& node = surface[nodes[i]];
    result.positions.push_back(distance(surface[nodes[0]], node));
    result.weights.push_back(node.weight);
    for (std::size_t j = 0; j < n; ++j) {
      result.traction[i * n + j] = -S(i, j) / (node.weight * surface.slipFactor());
    }
  }
  if (problem.reaction.reaction) {
    result.compression = compressionOf(problem, nodes, equilibrium);
  }
  auto const& rock = problem.fault_materials[nodes[n / 2]];
  result.half_plane = rock.shear_modulus / (problem.components == 1 ? 1 : 1 - rock.poissonsRatio());
  return result;
}

namespace
{
// The slip at a distance x from the middle of the window, and its traction. The traction is exact
// except for the tiny part of the slip's Fourier transform at negative wavenumbers, where -k/2 is
// not -|k|/2.
struct Wave
{
  double k, half_plane;

  double width() const { return 5 / k; }
  double window(double x) const { return std::exp(-x * x / (2 * width() * width())); }
  double slip(double x) const { return window(x) * std::cos(k * x); }
  double traction(double x) const
  {
    const double slope = -x / (width() * width()) * window(x);
    return -half_plane / 2 * (k * slip(x) + slope * std::sin(k * x));
  }
};

WaveError errorOf(FaultStiffness const& stiffness, Wave const& wave, double middle)
{
  const int n = stiffness.size();
  double found = 0, exact = 0;
  WaveError result;
  for (int i = 0; i < n; ++i) {
    const double x = stiffness.positions[i] - middle;
    const double share = stiffness.weights[i] * wave.slip(x);
    exact += share * wave.traction(x);
    for (int j = 0; j < n; ++j) {
      found += share * stiffness.traction[static_cast<std::size_t>(i) * n + j] *
               wave.slip(stiffness.positions[j] - middle);
    }
    if (i > 0 && wave.window(x) > 1e-4) {
      const double cell = stiffness.positions[i] - stiffness.positions[i - 1];
      result.largest_cell = std::max(result.largest_cell, cell);
      result.smallest_cell =
        result.smallest_cell == 0 ? cell : std::min(result.smallest_cell, cell);
    }
  }
  result.error = found / exact - 1;
  return result;
}
} // namespace

std::vector<WaveError> waveErrors(FaultStiffness const& stiffness)
{
  const int middle = stiffness.size() / 2;
  const double x = stiffness.positions[middle],
               to_ends = std::min(x, stiffness.positions.back() - x);
  std::vector<WaveError> errors;
  for (int cells = 12;; cells *= 2) {
    const Wave wave = {2 * M_PI / (cells * stiffness.weights[middle]), stiffness.half_plane};
    if (4 * wave.width() > to_ends) { // 3e-4 of the slip beyond
      return errors;
    }
    errors.push_back(errorOf(stiffness, wave, x));
    errors.back().cells = cells;
  }
}
