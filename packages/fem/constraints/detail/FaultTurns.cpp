#include "fem/constraints/detail/FaultTurns.hpp"

#include "base/DisjointSets.hpp"
#include "base/parallel/Reductions.hpp"
#include "fem/constraints/detail/ConditionNodes.hpp"
#include "fem/constraints/detail/NodalBasis.hpp"
#include "mesh/faults/Facing.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace asperity::fem::detail
{
namespace
{
// (size, size): 1 where an owned vertex has a facet of each of two boundaries, and no third one.
// A facet at a junction of three belongs to the fault that goes on there, whose vertex it has, or
// to a branch, which has a vertex of its own.
template <int Dim>
std::vector<int> meetings(Mesh<Dim> const& mesh, Boundaries const& names)
{
  std::map<int, std::vector<std::size_t>> at; // the boundaries of the facets at an owned vertex
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (auto const& facet : mesh.boundaries.at(names[i])) {
      for (const int vertex : facet) {
        if (vertex < mesh.num_owned) {
          at[vertex].push_back(i);
        }
      }
    }
  }
  std::vector<int> result(names.size() * names.size(), 0);
  for (auto const& [vertex, boundaries] : at) {
    if (boundaries.size() == 2) {
      result[boundaries[0] * names.size() + boundaries[1]] = 1;
    }
  }
  return result;
}

// The integral over boundaries of their inward normal [m^(Dim-1)].
template <int Dim>
std::vector<double> integralOfNormal(Mesh<Dim> const& mesh, Communicator const& communicator,
                                     Boundaries const& names)
{
  std::vector<double> sums(2, 0.);
  for (auto const& name : names) {
    for (auto const& [node, normal] : inwardNormals(mesh, 2, {name})) {
      sums[0] += normal[0] / Dim;
      sums[1] += normal[1] / Dim;
    }
  }
  return sumOverRanks(sums, communicator);
}

// 1 or -1. The tangents of a ring have no mean: they run counterclockwise, as plus is the outside.
template <int Dim>
int turnFor(Mesh<Dim> const& mesh, Communicator const& communicator, Boundaries const& names)
{
  constexpr int counterclockwise = -1;
  auto const facing = mesh::facingOf(mesh, names, communicator);
  auto const normal = integralOfNormal(mesh, communicator, names);
  const double size = std::hypot(normal[0], normal[1]);
  if (facing.isRing() || !facing.hasMeanNormal() || size == 0) {
    return counterclockwise;
  }
  const std::vector<double> mean = {normal[0] / size, normal[1] / size};
  return dot(tangentOf(mean, 1), tangentOf(mean, 0)) > 0 ? 1 : -1;
}
} // namespace

template <int Dim>
void chooseTurns(Mesh<Dim> const& mesh, Communicator const& communicator,
                 std::vector<VelocityCondition<Dim>>& conditions)
{
  std::set<std::string> along;
  for (auto const& condition : conditions) {
    if (condition.normal() == Normal::of_fault && mesh.boundaries.count(condition.boundary) > 0) {
      along.insert(condition.boundary);
    }
  }
  const Boundaries names(along.begin(), along.end());
  DisjointSets sets(names.size());
  auto const meet = maxOverRanks(meetings(mesh, names), communicator);
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = 0; j < names.size(); ++j) {
      if (meet[i * names.size() + j] > 0) {
        sets.join(i, j);
      }
    }
  }
  std::map<std::string, int> turns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Boundaries together;
    for (std::size_t j = 0; j < names.size(); ++j) {
      if (sets.find(j) == sets.find(i)) {
        together.push_back(names[j]);
      }
    }
    turns[names[i]] = turnFor(mesh, communicator, together);
  }
  for (auto& condition : conditions) {
    if (condition.normal() == Normal::of_fault && turns.count(condition.boundary) > 0) {
      condition.turn = turns.at(condition.boundary);
    }
  }
}

template void chooseTurns(Mesh<2> const&, Communicator const&, std::vector<VelocityCondition<2>>&);
template void chooseTurns(Mesh<3> const&, Communicator const&, std::vector<VelocityCondition<3>>&);
} // namespace asperity::fem::detail
