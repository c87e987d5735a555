#include "meshing/CellEstimate.hpp"

#include "arrangement/complex/Complex.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>

namespace asperity::geometry
{
namespace
{
// Measured on meshes of this program: the volume of a cell over size^3; the number of cells per
// vertex; and the vertices that each vertex of the outer surface adds to that estimate.
constexpr double cell_volume = 0.16, cells_per_vertex = 6.2, more_of_outer = 0.56;

double meanGround(Complex const& complex, Model const& model)
{
  double area = 0, volume = 0;
  for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
    if (model.isGround(complex.surfaces[i])) {
      const double on_map = std::abs(normalOf(complex.points, complex.triangles[i])[2]);
      area += on_map;
      volume += on_map * centroidOf(complex.points, complex.triangles[i])[2];
    }
  }
  return volume / area;
}

struct Brick
{
  Point<3> low, sides;
  double value; // volume / size^3, of the size in the middle
  double error; // about the largest error of value

  bool operator<(Brick const& other) const { return error < other.error; }
};

Brick brickOf(Point<3> const& low, Point<3> const& sides, CellSize const& size)
{
  Point<3> middle;
  double square = 0;
  for (int d = 0; d < 3; ++d) {
    middle[d] = low[d] + 0.5 * sides[d];
    square += sides[d] * sides[d];
  }
  const double h = size(middle);
  const double value = sides[0] * sides[1] * sides[2] / (h * h * h);
  // The size changes by at most growth times half of the diagonal.
  const double change = 0.5 * size.growth() * std::sqrt(square) / h;
  return {low, sides, value, value * std::min(1., change * change) + 1e-3 * change};
}

// The bricks with the largest errors are divided first.
double integrate(Point<3> const& low, Point<3> const& high, CellSize const& size)
{
  constexpr double wanted = 0.05; // relative error, about
  constexpr int most_bricks = 60000;
  Point<3> sides;
  for (int d = 0; d < 3; ++d) {
    sides[d] = high[d] - low[d];
  }
  std::priority_queue<Brick> bricks;
  bricks.push(brickOf(low, sides, size));
  double sum = bricks.top().value, error = bricks.top().error;
  for (int number = 1; number < most_bricks && (number < 512 || error > wanted * sum);) {
    const auto brick = bricks.top();
    bricks.pop();
    sum -= brick.value;
    error -= brick.error;
    const Point<3> half = {0.5 * brick.sides[0], 0.5 * brick.sides[1], 0.5 * brick.sides[2]};
    for (int i = 0; i < 8; ++i) {
      Point<3> corner = brick.low;
      for (int d = 0; d < 3; ++d) {
        corner[d] += (i >> d & 1) * half[d];
      }
      const auto part = brickOf(corner, half, size);
      sum += part.value;
      error += part.error;
      bricks.push(part);
    }
    number += 7;
  }
  return sum;
}
} // namespace

double facetArea(double size) { return std::sqrt(3.) / 4 * size * size; }

void addSamples(Samples& samples, Complex const& complex, Triangle const& triangle,
                CellSize const& size)
{
  constexpr double cells_apart = 3;
  constexpr int most = 40; // along an edge
  auto const& points = complex.points;
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    longest =
      std::max(longest, mesh::distance<3>(points[triangle[k]], points[triangle[(k + 1) % 3]]));
  }
  double smallest = size(centroidOf(points, triangle));
  for (int v : triangle) {
    smallest = std::min(smallest, size(points[v]));
  }
  const int n =
    std::clamp(static_cast<int>(std::ceil(longest / (cells_apart * smallest))), 1, most);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j + i < n; ++j) {
      for (int is_turned = 0; is_turned < (i + j + 1 < n ? 2 : 1); ++is_turned) {
        const double s = (i + (is_turned + 1) / 3.) / n, t = (j + (is_turned + 1) / 3.) / n;
        auto& place = samples.places.emplace_back();
        for (int d = 0; d < 3; ++d) {
          place[d] = (1 - s - t) * points[triangle[0]][d] + s * points[triangle[1]][d] +
                     t * points[triangle[2]][d];
        }
        samples.areas.push_back(areaOf(points, triangle) / (n * n));
      }
    }
  }
}

CellEstimate expectedCells(Complex const& complex, Model const& model, CellSize const& size)
{
  auto high = model.box.high;
  high[2] = meanGround(complex, model);
  CellEstimate estimate;
  estimate.cells = integrate(model.box.low, high, size) / cell_volume;
  double outer_facets = 0;
  for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
    Samples samples;
    addSamples(samples, complex, complex.triangles[i], size);
    auto& facets = model.isFault(complex.surfaces[i]) ? estimate.fault_facets : outer_facets;
    for (std::size_t k = 0; k < samples.places.size(); ++k) {
      facets += samples.areas[k] / facetArea(size(samples.places[k]));
    }
  }
  estimate.vertices = estimate.cells / cells_per_vertex + more_of_outer * outer_facets / 2;
  return estimate;
}
} // namespace asperity::geometry
