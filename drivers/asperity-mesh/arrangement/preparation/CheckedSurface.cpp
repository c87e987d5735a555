#include "arrangement/preparation/CheckedSurface.hpp"

#include "arrangement/preparation/SurfaceSheets.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace asperity::geometry
{
namespace
{
constexpr double equal_points = 1e-9; // of the extent of the surface

void requireNumbers(TriangleSurface const& surface, std::string const& where)
{
  ASPERITY_REQUIRE(!surface.triangles.empty(), where << " has no triangles.");
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    for (double x : surface.points[i]) {
      ASPERITY_REQUIRE(std::isfinite(x), where
                                           << ": point " << i + 1 << " of " << surface.points.size()
                                           << " has a coordinate that is not finite, " << x << ".");
    }
  }
  const auto number = static_cast<int>(surface.points.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    for (int v : surface.triangles[i]) {
      ASPERITY_REQUIRE(v >= 0 && v < number, where << ": triangle " << i + 1 << " names point "
                                                   << v + 1 << ", but there are " << number
                                                   << " points.");
    }
  }
}

// Finds points that are nearer to each other than a tolerance, in cells of a grid.
class PointNumbers
{
public:
  explicit PointNumbers(double tolerance) : tolerance_(tolerance) {}

  int numberOf(Point<3> const& point, std::vector<Point<3>>& points)
  {
    std::array<long long, 3> cell;
    for (int d = 0; d < 3; ++d) {
      cell[d] = static_cast<long long>(std::floor(point[d] / (2 * tolerance_)));
    }
    for (int i = 0; i < 27; ++i) {
      const auto found =
        of_cell_.find(key({cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1}));
      for (int j : found == of_cell_.end() ? std::vector<int>() : found->second) {
        if (mesh::distance<3>(points[j], point) <= tolerance_) {
          return j;
        }
      }
    }
    const auto number = static_cast<int>(points.size());
    of_cell_[key(cell)].push_back(number);
    points.push_back(point);
    return number;
  }

private:
  static std::size_t key(std::array<long long, 3> const& cell)
  {
    std::size_t value = 0;
    for (long long i : cell) {
      value = value * 1000003u + static_cast<std::size_t>(i);
    }
    return value;
  }

  double tolerance_;
  std::unordered_map<std::size_t, std::vector<int>> of_cell_; // by hash, which cells may share
};

void requireEdges(TriangleSurface const& surface, TrianglesAtEdges const& at_edges,
                  std::string const& where)
{
  std::set<Triangle> known;
  for (auto triangle : surface.triangles) {
    const auto place = centroidOf(surface.points, triangle);
    std::sort(triangle.begin(), triangle.end());
    ASPERITY_REQUIRE(known.insert(triangle).second,
                     where << " has a triangle twice, at " << placeText(place) << ".");
  }
  for (auto const& [edge, triangles] : at_edges) {
    ASPERITY_REQUIRE(triangles.size() <= 2, where << ": " << triangles.size()
                                                  << " triangles meet at the edge from "
                                                  << placeText(surface.points[edge[0]]) << " to "
                                                  << placeText(surface.points[edge[1]])
                                                  << ". Give each sheet as a surface of its own.");
  }
}

// Whether the triangle has the edge in its direction, from the lower number to the higher one.
bool isAscending(Triangle const& triangle, Edge const& edge)
{
  for (int k = 0; k < 3; ++k) {
    if (triangle[k] == edge[0] && triangle[(k + 1) % 3] == edge[1]) {
      return true;
    }
  }
  return false;
}

void orient(TriangleSurface& surface, TrianglesAtEdges const& at_edges, std::string const& where)
{
  auto& triangles = surface.triangles;
  std::vector<bool> is_known(triangles.size(), false);
  for (std::size_t start = 0; start < triangles.size(); ++start) {
    std::vector<int> queue;
    if (!is_known[start]) {
      is_known[start] = true;
      queue.push_back(static_cast<int>(start));
    }
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const int i = queue[next];
      for (int k = 0; k < 3; ++k) {
        const auto edge = edgeOf(triangles[i], k);
        for (int j : at_edges.at(edge)) {
          if (j == i) {
            continue;
          }
          const bool is_turned = isAscending(triangles[i], edge) == isAscending(triangles[j], edge);
          if (!is_known[j]) {
            is_known[j] = true;
            queue.push_back(j);
            if (is_turned) {
              std::swap(triangles[j][1], triangles[j][2]);
            }
          } else {
            ASPERITY_REQUIRE(!is_turned, where << " has only one side, as a Moebius strip, at "
                                               << placeText(surface.points[edge[0]])
                                               << ". Cut it into two surfaces.");
          }
        }
      }
    }
  }
}

// The surface with equal points merged, without triangles that lose their area by that.
TriangleSurface welded(TriangleSurface const& surface, std::string const& where)
{
  requireNumbers(surface, where);
  const double extent = extentOf(surface.points);
  ASPERITY_REQUIRE(extent > 0, where << ": all of its points are at one place, "
                                     << placeText(surface.points.front()) << ".");
  const double tolerance = equal_points * extent;
  TriangleSurface result;
  PointNumbers numbers(tolerance);
  std::vector<int> number_of;
  for (auto const& point : surface.points) {
    number_of.push_back(numbers.numberOf(point, result.points));
  }
  for (auto triangle : surface.triangles) {
    for (int& v : triangle) {
      v = number_of[v];
    }
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[0] == triangle[2]) {
      continue; // two of its points were merged, so that its neighbours have one edge in common
    }
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      longest = std::max(longest, mesh::distance<3>(result.points[triangle[k]],
                                                    result.points[triangle[(k + 1) % 3]]));
    }
    ASPERITY_REQUIRE(2 * areaOf(result.points, triangle) > tolerance * longest,
                     where << ": the triangle at " << placeText(centroidOf(result.points, triangle))
                           << " has no area. Repair the surface in the program that made it.");
    result.triangles.push_back(triangle);
  }
  ASPERITY_REQUIRE(!result.triangles.empty(), where << " has no triangle with an area.");
  return result;
}

TriangleSurface oriented(TriangleSurface surface, std::string const& where)
{
  const auto at_edges = trianglesAtEdges(surface.triangles);
  requireEdges(surface, at_edges, where);
  orient(surface, at_edges, where);
  return surface;
}
} // namespace

TriangleSurface checkedSurface(TriangleSurface const& surface, std::string const& where)
{
  return oriented(welded(surface, where), where);
}

std::vector<TriangleSurface> checkedSheets(TriangleSurface const& surface, std::string const& where)
{
  std::vector<TriangleSurface> sheets;
  for (auto& sheet : sheetsOf(welded(surface, where))) {
    sheets.push_back(oriented(std::move(sheet), where));
  }
  return sheets;
}
} // namespace asperity::geometry
