#include "mesh/MeetingFaults.hpp"

#include "mesh/Crossings.hpp"
#include "mesh/Joints.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace asperity::mesh
{
namespace
{
using Names = std::array<std::string, 2>;

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
Names namesOf(AnyMesh<Dim> const& mesh, std::array<int, 2> const& plus)
{
  return {nameOfFaultAt(mesh, plus[0]), nameOfFaultAt(mesh, plus[1])};
}

template <template <int> class AnyMesh, int Dim>
Names ascendingNamesOf(AnyMesh<Dim> const& mesh, std::array<int, 2> const& plus)
{
  auto names = namesOf(mesh, plus);
  std::sort(names.begin(), names.end());
  return names;
}
} // namespace

template <template <int> class AnyMesh, int Dim>
std::vector<NamedCrossing<Dim>> namedCrossings(AnyMesh<Dim> const& mesh)
{
  std::vector<NamedCrossing<Dim>> named;
  for (auto const& crossing : crossingsOf(mesh.splits)) {
    named.push_back({mesh.vertices[crossing.mean], ascendingNamesOf(mesh, crossing.plus)});
  }
  return named;
}

namespace
{
// (num_places) of each place at which two faults meet, the plus vertex of either.
using Meetings = std::vector<std::array<int, 2>>;
using Edge = std::pair<int, int>; // two of the places, ascending

// The edges between such places that one of the two faults, 0 or 1, has.
template <int Dim>
std::set<Edge> edgesOf(int fault, Meetings const& meetings, GlobalMesh<Dim> const& mesh)
{
  std::map<int, std::vector<int>> places; // by the plus vertex, which branches on both sides share
  for (std::size_t place = 0; place < meetings.size(); ++place) {
    places[meetings[place][fault]].push_back(static_cast<int>(place));
  }
  const auto placesAt = [&](int vertex) {
    const auto found = places.find(vertex);
    return found == places.end() ? std::vector<int>() : found->second;
  };
  std::set<Edge> edges;
  for (auto const& name : mesh.faults) {
    for (auto const& facet : mesh.boundaries.at(name)) {
      for (int a : facet) {
        for (int first : placesAt(a)) {
          for (int b : facet) {
            for (int second : placesAt(b)) {
              if (first < second) {
                edges.insert({first, second});
              }
            }
          }
        }
      }
    }
  }
  return edges;
}

// The edges between such places that both faults have.
template <int Dim>
std::vector<Edge> commonEdges(Meetings const& meetings, GlobalMesh<Dim> const& mesh)
{
  const auto first = edgesOf(0, meetings, mesh), second = edgesOf(1, meetings, mesh);
  std::vector<Edge> edges;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                        std::back_inserter(edges));
  return edges;
}

template <int Dim>
Point<Dim> farthestFrom(Point<Dim> const& from, std::vector<Point<Dim>> const& places)
{
  return *std::max_element(places.begin(), places.end(), [&](auto const& a, auto const& b) {
    return distance<Dim>(a, from) < distance<Dim>(b, from);
  });
}

// All lines, without names, and the first place of each.
template <int Dim>
std::vector<std::pair<MeetingLine<Dim>, int>> linesOf(Meetings const& meetings,
                                                      GlobalMesh<Dim> const& mesh)
{
  std::vector<std::vector<std::pair<int, double>>> neighbours(meetings.size()); // and distances
  const auto placeOf = [&](int number) { return mesh.vertices[meetings[number][0]]; };
  for (auto const& [a, b] : commonEdges(meetings, mesh)) {
    const double length = distance<Dim>(placeOf(a), placeOf(b));
    neighbours[a].emplace_back(b, length);
    neighbours[b].emplace_back(a, length);
  }
  std::vector<std::pair<MeetingLine<Dim>, int>> lines;
  std::vector<bool> is_done(meetings.size(), false);
  for (std::size_t first = 0; first < meetings.size(); ++first) {
    if (is_done[first]) {
      continue;
    }
    is_done[first] = true;
    MeetingLine<Dim> line;
    std::vector<int> numbers = {static_cast<int>(first)};
    std::vector<Point<Dim>> places;
    for (std::size_t next = 0; next < numbers.size(); ++next) {
      places.push_back(placeOf(numbers[next]));
      for (auto const& [other, length] : neighbours[numbers[next]]) {
        line.length += length / 2; // from either end of the edge
        if (!is_done[other]) {
          is_done[other] = true;
          numbers.push_back(other);
        }
      }
    }
    line.num_vertices = static_cast<int>(numbers.size());
    line.ends[1] = farthestFrom<Dim>(places[0], places);
    line.ends[0] = farthestFrom<Dim>(line.ends[1], places);
    lines.emplace_back(line, numbers[0]);
  }
  return lines;
}
} // namespace

template <int Dim>
std::vector<MeetingLine<Dim>> crossingLines(GlobalMesh<Dim> const& mesh)
{
  Meetings meetings;
  for (auto const& crossing : crossingsOf(mesh.splits)) {
    meetings.push_back(crossing.plus);
  }
  std::vector<MeetingLine<Dim>> lines;
  for (auto [line, first] : linesOf(meetings, mesh)) {
    line.faults = ascendingNamesOf(mesh, meetings[first]);
    lines.push_back(line);
  }
  return lines;
}

template <int Dim>
std::vector<MeetingLine<Dim>> jointLines(GlobalMesh<Dim> const& mesh)
{
  Meetings meetings;
  for (auto const& joint : jointsOf(mesh.splits)) {
    meetings.push_back({joint.plus, joint.main});
  }
  std::vector<MeetingLine<Dim>> lines;
  for (auto [line, first] : linesOf(meetings, mesh)) {
    line.faults = namesOf(mesh, meetings[first]);
    lines.push_back(line);
  }
  return lines;
}

template std::vector<MeetingLine<2>> crossingLines(GlobalMesh<2> const&);
template std::vector<MeetingLine<3>> crossingLines(GlobalMesh<3> const&);
template std::vector<MeetingLine<2>> jointLines(GlobalMesh<2> const&);
template std::vector<MeetingLine<3>> jointLines(GlobalMesh<3> const&);
template std::vector<NamedCrossing<2>> namedCrossings(GlobalMesh<2> const&);
template std::vector<NamedCrossing<3>> namedCrossings(GlobalMesh<3> const&);
template std::vector<NamedCrossing<2>> namedCrossings(Mesh<2> const&);
template std::vector<NamedCrossing<3>> namedCrossings(Mesh<3> const&);
} // namespace asperity::mesh
