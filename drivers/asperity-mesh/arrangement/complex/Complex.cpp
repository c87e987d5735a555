#include "arrangement/complex/Complex.hpp"

#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::geometry
{
TrianglesAtEdges trianglesAtEdges(std::vector<Triangle> const& triangles)
{
  TrianglesAtEdges result;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      result[edgeOf(triangles[i], k)].push_back(static_cast<int>(i));
    }
  }
  return result;
}

Point<3> normalOf(std::vector<Point<3>> const& points, Triangle const& triangle)
{
  auto const& a = points[triangle[0]];
  return mesh::cross(mesh::difference<3>(points[triangle[1]], a),
                     mesh::difference<3>(points[triangle[2]], a));
}

double areaOf(std::vector<Point<3>> const& points, Triangle const& triangle)
{
  return 0.5 * mesh::distance<3>(normalOf(points, triangle), {});
}

double areaOf(TriangleSurface const& surface)
{
  double sum = 0;
  for (auto const& triangle : surface.triangles) {
    sum += areaOf(surface.points, triangle);
  }
  return sum;
}

Point<3> centroidOf(std::vector<Point<3>> const& points, Triangle const& triangle)
{
  Point<3> sum{};
  for (int v : triangle) {
    for (int d = 0; d < 3; ++d) {
      sum[d] += points[v][d] / 3;
    }
  }
  return sum;
}

Point<3> inward(std::vector<Point<3>> const& points, Edge const& edge, Triangle const& triangle)
{
  int apex = triangle[0];
  for (int v : triangle) {
    apex = v != edge[0] && v != edge[1] ? v : apex;
  }
  auto const& a = points[edge[0]];
  const auto along = mesh::difference<3>(points[edge[1]], a);
  auto in = mesh::difference<3>(points[apex], a);
  const double share = mesh::dot<3>(in, along) / mesh::dot<3>(along, along);
  for (int d = 0; d < 3; ++d) {
    in[d] -= share * along[d];
  }
  const double length = std::sqrt(mesh::dot<3>(in, in));
  return {in[0] / length, in[1] / length, in[2] / length};
}

void keepTriangles(Complex& complex, std::vector<bool> const& is_kept, std::vector<int>* points)
{
  Complex kept;
  std::vector<int> number(complex.points.size(), -1);
  for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
    if (!is_kept[i]) {
      continue;
    }
    Triangle triangle = complex.triangles[i];
    for (int& v : triangle) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(kept.points.size());
        kept.points.push_back(complex.points[v]);
      }
      v = number[v];
    }
    kept.triangles.push_back(triangle);
    kept.surfaces.push_back(complex.surfaces[i]);
  }
  complex = std::move(kept);
  if (points != nullptr) {
    *points = std::move(number);
  }
}

std::string placeText(Point<3> const& place)
{
  return formatPoint({place[0] / 1000, place[1] / 1000, place[2] / 1000}) + " km";
}

double extentOf(std::vector<Point<3>> const& points)
{
  Point<3> low = points.front(), high = low;
  for (auto const& point : points) {
    for (int d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], point[d]);
      high[d] = std::max(high[d], point[d]);
    }
  }
  return mesh::distance<3>(low, high);
}

std::string extentText(std::vector<Point<3>> const& points)
{
  std::string text;
  for (int d = 0; d < 3; ++d) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (auto const& point : points) {
      low = std::min(low, point[d]);
      high = std::max(high, point[d]);
    }
    text += (d == 0 ? "" : ", ") + std::string(1, "xyz"[d]) + " from " + formatShort(low / 1000) +
            " to " + formatShort(high / 1000);
  }
  return text + " km";
}
} // namespace asperity::geometry
