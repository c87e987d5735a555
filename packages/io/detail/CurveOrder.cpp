#include "io/detail/CurveOrder.hpp"

#include "base/Errors.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace asperity::io::detail
{
namespace
{
using Neighbours = std::map<GlobalOrdinal, std::vector<GlobalOrdinal>>;

Neighbours neighboursAlong(std::vector<Segment> const& segments,
                           std::map<GlobalOrdinal, PlanePoint> const& coordinates)
{
  Neighbours neighbours;
  for (auto const& segment : segments) {
    neighbours[segment[0]].push_back(segment[1]);
    neighbours[segment[1]].push_back(segment[0]);
  }
  for (auto const& entry : neighbours) {
    auto const& point = coordinates.at(entry.first);
    ASPERITY_REQUIRE(entry.second.size() <= 2,
                     "The boundary branches at x = "
                       << point[0] << ", y = " << point[1] << " m: " << entry.second.size()
                       << " segments meet there. Give each branch a name of its own.");
  }
  return neighbours;
}

// For each vertex the number of greater heights among all; 0 for all if height does not matter.
std::map<GlobalOrdinal, int> ranksByHeight(std::vector<GlobalOrdinal> const& vertices,
                                           std::map<GlobalOrdinal, PlanePoint> const& coordinates,
                                           CurveStart start)
{
  std::vector<std::pair<double, GlobalOrdinal>> heights;
  PlanePoint least = coordinates.begin()->second, largest = least;
  for (auto const& [vertex, point] : coordinates) {
    for (int d = 0; d < 2; ++d) {
      least[d] = std::min(least[d], point[d]);
      largest[d] = std::max(largest[d], point[d]);
    }
  }
  for (const GlobalOrdinal vertex : vertices) {
    heights.emplace_back(coordinates.at(vertex)[1], vertex);
  }
  std::sort(heights.rbegin(), heights.rend());
  const double equal = equally_high * std::hypot(largest[0] - least[0], largest[1] - least[1]);
  std::map<GlobalOrdinal, int> ranks;
  double before = heights.empty() ? 0 : heights.front().first;
  int rank = 0;
  for (auto const& [height, vertex] : heights) {
    rank += start == CurveStart::upper_end && before - height > equal ? 1 : 0;
    ranks[vertex] = rank;
    before = height;
  }
  return ranks;
}

// Vertices in the order in which a walk may begin at them: first the ends of open pieces, then all
// (for closed pieces).
std::vector<GlobalOrdinal> possibleStarts(Neighbours const& neighbours,
                                          std::map<GlobalOrdinal, PlanePoint> const& coordinates,
                                          CurveStart start)
{
  std::vector<GlobalOrdinal> ends, inner;
  for (auto const& [vertex, others] : neighbours) {
    (others.size() == 2 ? inner : ends).push_back(vertex);
  }
  for (auto* const starts : {&ends, &inner}) {
    const auto ranks = ranksByHeight(*starts, coordinates, start);
    std::sort(starts->begin(), starts->end(), [&](GlobalOrdinal left, GlobalOrdinal right) {
      return std::make_tuple(ranks.at(left), coordinates.at(left), left) <
             std::make_tuple(ranks.at(right), coordinates.at(right), right);
    });
  }
  ends.insert(ends.end(), inner.begin(), inner.end());
  return ends;
}
} // namespace

CurveOrder orderCurve(std::vector<Segment> const& segments,
                      std::map<GlobalOrdinal, PlanePoint> const& coordinates, CurveStart start)
{
  const Neighbours neighbours = neighboursAlong(segments, coordinates);
  CurveOrder order;
  std::set<GlobalOrdinal> visited;
  double position = 0;
  for (const GlobalOrdinal first : possibleStarts(neighbours, coordinates, start)) {
    GlobalOrdinal vertex = first;
    while (visited.insert(vertex).second) {
      order.vertex_ids.push_back(vertex);
      order.positions.push_back(position);
      for (const GlobalOrdinal next : neighbours.at(vertex)) {
        if (visited.count(next) == 0) {
          auto const& from = coordinates.at(vertex);
          auto const& to = coordinates.at(next);
          position += std::hypot(to[0] - from[0], to[1] - from[1]);
          vertex = next;
          break;
        }
      }
    }
  }
  return order;
}
} // namespace asperity::io::detail
