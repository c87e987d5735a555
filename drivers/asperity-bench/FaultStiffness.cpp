#include "FaultStiffness.hpp"

#include "base/Errors.hpp"
#include "dynamics/fault/NormalReaction.hpp"
#include "fem/BodyMatrices.hpp"
#include "scenario/problem/Problem.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::bench
{
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
  auto const& body = problem.model.body;
  const std::size_t n = nodes.size();
  auto const zero = body.vector(), u = body.vector();
  Vector slip(equilibrium.map());
  auto const no_forces = equilibrium.condense(*zero);
  const NodeView R("asperity::bench::R", problem.surface().numNodes());
  std::vector<double> result(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    slip.putScalar(0);
    slip.replaceLocalValue(static_cast<int>(j), 1 / problem.surface().slipFactor());
    no_forces.expand(slip, *u);
    problem.model.reaction.reaction->compression(*zero, {*u, *zero, *zero, {}}, R);
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
  auto const problem = scenario::makeProblem<2>(deck, communicator);
  auto const& surface = problem.surface();
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
    *fem::combine(problem.model.body.matrices, fem::elasticityWeights(problem.model.body.matrices),
                  problem.model.body.held),
    dofs);

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
  if (problem.model.reaction.reaction) {
    result.compression = compressionOf(problem, nodes, equilibrium);
  }
  auto const& rock = problem.fault_materials[nodes[n / 2]];
  result.half_plane =
    rock.shear_modulus / (problem.components() == 1 ? 1 : 1 - rock.poissonsRatio());
  return result;
}
} // namespace asperity::bench
