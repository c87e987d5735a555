#include "mesh/Crossings.hpp"

#include "base/Errors.hpp"
#include "mesh/PointText.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>

namespace asperity::mesh
{
namespace
{
// The pluses of the pairs of faults that go on, ascending, by their minus.
std::map<int, std::vector<int>> plusesOf(std::vector<SplitVertex> const& splits)
{
  std::map<int, std::vector<int>> pluses;
  for (auto const& pair : splits) {
    if (!pair.is_tip && !pair.is_joint) {
      pluses[pair.minus].push_back(pair.plus);
    }
  }
  return pluses;
}

// The name of the fault that has this vertex, as in NamedCrossing: that of each of its boundaries
// there, joined by "/". Empty on a part without a facet of it.
template <template <int> class AnyMesh, int Dim>
std::string nameOfFaultAt(AnyMesh<Dim> const& mesh, int plus)
{
  std::string names;
  for (auto const& name : mesh.faults) {
    auto const& facets = mesh.boundaries.at(name);
    const bool has_it = std::any_of(facets.begin(), facets.end(), [&](auto const& facet) {
      return std::find(facet.begin(), facet.end(), plus) != facet.end();
    });
    names += !has_it ? "" : names.empty() ? name : "/" + name;
  }
  return names;
}

template <template <int> class AnyMesh, int Dim>
std::array<std::string, 2> namesOf(AnyMesh<Dim> const& mesh, Crossing const& crossing)
{
  std::array<std::string, 2> names = {nameOfFaultAt(mesh, crossing.plus[0]),
                                      nameOfFaultAt(mesh, crossing.plus[1])};
  std::sort(names.begin(), names.end());
  return names;
}
} // namespace

std::vector<Crossing> crossingsOf(std::vector<SplitVertex> const& splits)
{
  std::vector<Crossing> crossings;
  for (auto const& [mean, plus] : plusesOf(splits)) {
    if (plus.size() == 3) {
      crossings.push_back({mean, {plus[0], plus[1]}, plus[2]});
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](Crossing const& a, Crossing const& b) { return a.plus[0] < b.plus[0]; });
  return crossings;
}

template <template <int> class AnyMesh, int Dim>
void checkCrossings(AnyMesh<Dim> const& mesh, std::string const& where)
{
  for (auto const& [minus, plus] : plusesOf(mesh.splits)) {
    ASPERITY_REQUIRE(plus.size() == 1 || plus.size() == 3,
                     where << ": vertex " << minus << " at " << text(mesh.vertices[minus])
                           << " is the minus of " << plus.size()
                           << " pairs at faults. It may be that of one pair, or of three where two "
                              "faults cross.");
  }
}

template <template <int> class AnyMesh, int Dim>
std::vector<NamedCrossing<Dim>> namedCrossings(AnyMesh<Dim> const& mesh)
{
  std::vector<NamedCrossing<Dim>> named;
  for (auto const& crossing : crossingsOf(mesh.splits)) {
    named.push_back({mesh.vertices[crossing.mean], namesOf(mesh, crossing)});
  }
  return named;
}

namespace
{
// (num_crossings) the crossings that edges of both faults connect with each one.
template <int Dim>
std::vector<std::vector<int>> neighboursOf(std::vector<Crossing> const& crossings,
                                           GlobalMesh<Dim> const& mesh)
{
  std::map<int, std::pair<int, int>> of_plus; // the crossing and its fault, 0 or 1
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    for (int fault : {0, 1}) {
      of_plus[crossings[c].plus[fault]] = {static_cast<int>(c), fault};
    }
  }
  std::map<std::pair<int, int>, std::array<bool, 2>> edges; // whether either fault has the edge
  for (auto const& name : mesh.faults) {
    for (auto const& facet : mesh.boundaries.at(name)) {
      for (int a : facet) {
        for (int b : facet) {
          const auto first = of_plus.find(a), second = of_plus.find(b);
          if (first != of_plus.end() && second != of_plus.end() &&
              first->second.first < second->second.first) {
            edges[{first->second.first, second->second.first}][first->second.second] = true;
          }
        }
      }
    }
  }
  std::vector<std::vector<int>> neighbours(crossings.size());
  for (auto const& [edge, has_it] : edges) {
    if (has_it[0] && has_it[1]) {
      neighbours[edge.first].push_back(edge.second);
      neighbours[edge.second].push_back(edge.first);
    }
  }
  return neighbours;
}

template <int Dim>
Point<Dim> farthestFrom(Point<Dim> const& from, std::vector<Point<Dim>> const& places)
{
  return *std::max_element(places.begin(), places.end(), [&](auto const& a, auto const& b) {
    return distance<Dim>(a, from) < distance<Dim>(b, from);
  });
}
} // namespace

template <int Dim>
std::vector<CrossingLine<Dim>> crossingLines(GlobalMesh<Dim> const& mesh)
{
  const auto crossings = crossingsOf(mesh.splits);
  const auto neighbours = neighboursOf(crossings, mesh);
  std::vector<CrossingLine<Dim>> lines;
  std::vector<bool> is_done(crossings.size(), false);
  for (std::size_t first = 0; first < crossings.size(); ++first) {
    if (is_done[first]) {
      continue;
    }
    is_done[first] = true;
    std::vector<int> line = {static_cast<int>(first)};
    std::vector<Point<Dim>> places;
    for (std::size_t next = 0; next < line.size(); ++next) {
      places.push_back(mesh.vertices[crossings[line[next]].mean]);
      for (int other : neighbours[line[next]]) {
        if (!is_done[other]) {
          is_done[other] = true;
          line.push_back(other);
        }
      }
    }
    const auto end = farthestFrom<Dim>(places[0], places);
    lines.push_back({namesOf(mesh, crossings[first]),
                     static_cast<int>(line.size()),
                     {farthestFrom<Dim>(end, places), end}});
  }
  return lines;
}

template std::vector<CrossingLine<2>> crossingLines(GlobalMesh<2> const&);
template std::vector<CrossingLine<3>> crossingLines(GlobalMesh<3> const&);

#define ASPERITY_INSTANTIATE(AnyMesh, Dim)                                                         \
  template void checkCrossings(AnyMesh<Dim> const&, std::string const&);                           \
  template std::vector<NamedCrossing<Dim>> namedCrossings(AnyMesh<Dim> const&);
ASPERITY_INSTANTIATE(GlobalMesh, 2)
ASPERITY_INSTANTIATE(GlobalMesh, 3)
ASPERITY_INSTANTIATE(Mesh, 2)
ASPERITY_INSTANTIATE(Mesh, 3)
#undef ASPERITY_INSTANTIATE
} // namespace asperity::mesh
