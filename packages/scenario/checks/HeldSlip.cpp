#include "scenario/checks/HeldSlip.hpp"

#include "base/Text.hpp"
#include "base/parallel/FirstRank.hpp"
#include "base/parallel/Reductions.hpp"
#include "mesh/MeshQuality.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace asperity::scenario
{
namespace
{
constexpr int num_instants = 16; // at which velocities of conditions are read

bool isAmong(std::vector<int> const& vertices, fem::FaultNode const& node)
{
  return std::any_of(node.copies.begin(), node.copies.end(), [&](int vertex) {
    return std::binary_search(vertices.begin(), vertices.end(), vertex);
  });
}

// (num_nodes) whether other conditions than those along the fault prescribe all slip of the node.
template <int Dim>
std::vector<bool> heldNodes(Problem<Dim> const& problem,
                            std::vector<BoundaryCondition> const& conditions)
{
  auto const& surface = problem.surface();
  std::vector<bool> held;
  for (int node = 0; node < surface.numNodes(); ++node) {
    held.push_back(!surface.counts(node));
  }
  for (auto const& pair : problem.mesh().splits) {
    const int node = pair.plus < problem.mesh().num_owned ? surface.nodeAt(pair.plus) : -1;
    if ((pair.is_tip || pair.is_joint) && node >= 0) { // another fault holds slip there
      held[node] = false;
    }
  }
  for (auto const& condition : conditions) {
    if (condition.type->place == ConditionPlace::continuation) {
      auto const vertices = mesh::boundaryVertices(problem.mesh(), condition.boundary);
      for (int node = 0; node < surface.numNodes(); ++node) {
        held[node] = held[node] && !isAmong(vertices, surface[node]);
      }
    }
  }
  return held;
}

// (num_nodes) the largest slip rate [m/s] if all slip of the node is prescribed. Collective.
template <int Dim>
std::vector<double> prescribedRates(Problem<Dim> const& problem, double end)
{
  auto const& surface = problem.surface();
  std::vector<double> largest(surface.numNodes(), 0.);
  auto const v = problem.model.body.vector();
  for (int i = 0; i <= num_instants; ++i) {
    problem.model.body.prescribed_velocity(end * i / num_instants, *v);
    auto const values = v->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (int node = 0; node < surface.numNodes(); ++node) {
      double square = 0;
      for (int k = 0; k < surface.numTangents(); ++k) {
        const double rate =
          surface.slipFactor() * values(surface[node].dofs[k], 0) + surface.plateRate(node, k);
        square += rate * rate;
      }
      largest[node] = std::max(largest[node], std::sqrt(square));
    }
  }
  return largest;
}

// What the nodes of a fault that a boundary holds have in common, over all ranks.
struct HeldEnd
{
  long long num_nodes = 0;
  double rate = 0;                            // the largest [m/s]
  std::optional<std::array<double, 3>> place; // of one of them [m]
};

// Takes the nodes that it finds out of `held`, so that each is reported for one boundary.
template <int Dim>
HeldEnd heldEnd(Problem<Dim> const& problem, std::vector<bool>& held,
                std::vector<double> const& rates, std::vector<int> const& vertices)
{
  auto const& surface = problem.surface();
  HeldEnd end;
  for (int node = 0; node < surface.numNodes(); ++node) {
    if (held[node] && isAmong(vertices, surface[node])) {
      ++end.num_nodes;
      held[node] = false;
      end.rate = std::max(end.rate, rates[node]);
      end.place = end.place.value_or(surface[node].place);
    }
  }
  auto const& communicator = *problem.communicator;
  end.place = ofFirstRank(end.place, communicator);
  end.num_nodes = sumOverRanks(end.num_nodes, communicator);
  end.rate = maxOverRanks(end.rate, communicator);
  return end;
}

// A condition that holds all directions comes before one in a direction of its own, and that before
// a wall.
int holdsMore(BoundaryCondition const& condition)
{
  auto const& type = *condition.type;
  const bool has_own_direction =
    !condition.liesAlongFault() && type.readsEntry(condition_entries::direction);
  return type.decides_on == DecidesOn::rest ? 2 : has_own_direction ? 1 : 0;
}
} // namespace

template <int Dim>
void describeHeldSlip(Problem<Dim> const& problem, Description& description)
{
  if (problem.surface().numSliding() == 0) {
    return;
  }
  // A corner of a boundary that is held in all directions and a wall is reported for the former.
  auto conditions = problem.settings.conditions;
  std::stable_sort(conditions.begin(), conditions.end(),
                   [](auto const& a, auto const& b) { return holdsMore(a) > holdsMore(b); });
  auto held = heldNodes(problem, conditions);
  auto const rates = prescribedRates(problem, problem.settings.time.final_time);
  for (auto const& condition : conditions) {
    if (condition.liesAlongFault()) {
      continue;
    }
    auto const end =
      heldEnd(problem, held, rates, mesh::boundaryVertices(problem.mesh(), condition.boundary));
    if (end.num_nodes == 0) {
      continue;
    }
    const std::string text =
      "The fault ends on the boundary '" + condition.boundary + "' (" + condition.type->name +
      "), which prescribes the slip of " +
      (end.num_nodes == 1 ? "its node" : std::to_string(end.num_nodes) + " of its nodes, one") +
      " at " + formatPoint({end.place->begin(), end.place->begin() + Dim}) + " m: ";
    if (end.rate > 0) {
      description.lines.push_back(text + "up to " + formatShort(end.rate) + " m/s.");
    } else {
      description.warnings.push_back(
        {"slip at a boundary",
         text +
           "none. Stress grows there as at the tip of a crack. If "
           "the fault is to slip there, choose a Type that leaves motion along the fault free: "
           "Free Surface, or Sliding Wall where the fault lies along that wall; or let a "
           "boundary of the Type " +
           continuationType().name + " continue the fault."});
    }
  }
}

template void describeHeldSlip(Problem<2> const&, Description&);
template void describeHeldSlip(Problem<3> const&, Description&);
} // namespace asperity::scenario
