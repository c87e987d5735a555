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

// Vertices by coordinates: first the ends of open pieces, then all (for closed pieces).
std::vector<GlobalOrdinal> possibleStarts(Neighbours const& neighbours,
                                          std::map<GlobalOrdinal, PlanePoint> const& coordinates)
{
  std::vector<GlobalOrdinal> starts;
  for (auto const& entry : neighbours) {
    starts.push_back(entry.first);
  }
  const auto isInner = [&](GlobalOrdinal vertex) { return neighbours.at(vertex).size() == 2; };
  std::sort(starts.begin(), starts.end(), [&](GlobalOrdinal left, GlobalOrdinal right) {
    return std::make_tuple(isInner(left), coordinates.at(left), left) <
           std::make_tuple(isInner(right), coordinates.at(right), right);
  });
  return starts;
}
} // namespace

CurveOrder orderCurve(std::vector<Segment> const& segments,
                      std::map<GlobalOrdinal, PlanePoint> const& coordinates)
{
  const Neighbours neighbours = neighboursAlong(segments, coordinates);
  CurveOrder order;
  std::set<GlobalOrdinal> visited;
  double position = 0;
  for (const GlobalOrdinal start : possibleStarts(neighbours, coordinates)) {
    GlobalOrdinal vertex = start;
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
