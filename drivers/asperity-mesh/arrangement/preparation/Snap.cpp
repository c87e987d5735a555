#include "arrangement/preparation/Snap.hpp"

#include "arrangement/complex/Complex.hpp"
#include "arrangement/complex/TriangleTree.hpp"
#include "surfaces/TriangleSurface.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <cmath>
#include <map>
#include <vector>

namespace asperity::geometry
{
namespace
{
constexpr double push = 3; // displacement of a border point, in units of snap

Point<3> scaled(Point<3> const& v, double factor)
{
  return {v[0] * factor, v[1] * factor, v[2] * factor};
}
Point<3> unit(Point<3> const& v) { return scaled(v, 1 / std::sqrt(mesh::dot<3>(v, v))); }
Point<3> plus(Point<3> const& a, Point<3> const& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

TriangleTree treeOfOthers(Model const& model, int self)
{
  std::vector<Point<3>> points;
  std::vector<Triangle> triangles;
  for (int s = 0; s < static_cast<int>(model.surfaces.size()); ++s) {
    if (s == self) {
      continue;
    }
    auto const& surface = model.surfaces[s].surface;
    const auto offset = static_cast<int>(points.size());
    points.insert(points.end(), surface.points.begin(), surface.points.end());
    for (auto const& t : surface.triangles) {
      triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
  }
  return {points, triangles};
}

// The displacements of border points that are near other surfaces, by point.
std::map<int, Point<3>> displacements(TriangleSurface const& surface, TriangleTree const& others,
                                      double snap)
{
  std::map<int, bool> known;
  const auto isNear = [&](int v) {
    const auto [place, is_new] = known.emplace(v, false);
    if (is_new) {
      place->second = others.nearest(surface.points[v], snap).triangle >= 0;
    }
    return place->second;
  };
  std::map<int, Point<3>> sums, lateral; // lateral: along the side that leads away from the surface
  for (auto const& [side, triangles] : trianglesAtEdges(surface.triangles)) {
    if (triangles.size() > 1) {
      continue;
    }
    const bool first = isNear(side[0]), second = isNear(side[1]);
    if (first && second) {
      const auto direction =
        scaled(inward(surface.points, side, surface.triangles[triangles[0]]), -1);
      for (int v : side) {
        sums[v] = plus(sums[v], direction);
      }
    } else if (first || second) {
      const int v = side[first ? 0 : 1], w = side[first ? 1 : 0];
      lateral[v] = mesh::difference<3>(surface.points[v], surface.points[w]);
    }
  }
  std::map<int, Point<3>> moves;
  for (auto const& [v, sum] : sums) {
    const auto side = lateral.find(v);
    const auto move = scaled(unit(side == lateral.end() ? sum : side->second), push * snap);
    auto const& from = surface.points[v];
    // The segment begins inside the fault, since the point itself may lie on the other surface.
    if (others.isCrossedBy(plus(from, scaled(move, -1 / push)), plus(from, move))) {
      moves.emplace(v, move);
    }
  }
  return moves;
}
// Removes displacements that would turn the normal of a triangle by 60 degrees or more.
void leaveFolds(TriangleSurface const& surface, std::map<int, Point<3>>& moves)
{
  constexpr double smallest = 0.5; // cosine
  auto moved = surface.points;
  for (auto const& [v, move] : moves) {
    moved[v] = plus(moved[v], move);
  }
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (auto const& triangle : surface.triangles) {
      const auto before = normalOf(surface.points, triangle), after = normalOf(moved, triangle);
      if (mesh::dot<3>(before, after) >=
          smallest * std::sqrt(mesh::dot<3>(before, before) * mesh::dot<3>(after, after))) {
        continue;
      }
      for (int v : triangle) {
        moved[v] = surface.points[v];
        is_changed = moves.erase(v) > 0 || is_changed;
      }
    }
  }
}
} // namespace

std::vector<std::vector<bool>> pushBorders(Model& model, double snap)
{
  std::vector<std::vector<bool>> is_moved;
  for (auto const& surface : model.surfaces) {
    is_moved.emplace_back(surface.surface.points.size(), false);
  }
  if (snap <= 0) {
    return is_moved;
  }
  std::vector<std::map<int, Point<3>>> moves; // all are found before a point moves
  for (int s = 0; s < model.num_faults; ++s) {
    moves.push_back(displacements(model.surfaces[s].surface, treeOfOthers(model, s), snap));
  }
  for (int s = 0; s < model.num_faults; ++s) {
    leaveFolds(model.surfaces[s].surface, moves[s]);
    for (auto const& [v, move] : moves[s]) {
      auto& point = model.surfaces[s].surface.points[v];
      point = plus(point, move);
      is_moved[s][v] = true;
    }
  }
  return is_moved;
}
} // namespace asperity::geometry
