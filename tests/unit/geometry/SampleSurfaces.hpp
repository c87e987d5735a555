#pragma once

#include "building/BuildMesh.hpp"

#include <cmath>
#include <functional>

namespace asperity::geometry
{
// Surfaces of tests; lengths in m.
constexpr double km = 1000;

inline Point<3> at(Point<3> const& origin, double s, Point<3> const& u, double t, Point<3> const& v)
{
  Point<3> x;
  for (int d = 0; d < 3; ++d) {
    x[d] = origin[d] + s * u[d] + t * v[d];
  }
  return x;
}

// place(s, t) with s and t from 0 to 1, on num_s x num_t quadrilaterals.
inline TriangleSurface gridSurface(std::function<Point<3>(double, double)> const& place, int num_s,
                                   int num_t)
{
  TriangleSurface surface;
  for (int i = 0; i <= num_s; ++i) {
    for (int j = 0; j <= num_t; ++j) {
      surface.points.push_back(place(double(i) / num_s, double(j) / num_t));
    }
  }
  for (int i = 0; i < num_s; ++i) {
    for (int j = 0; j < num_t; ++j) {
      const int a = i * (num_t + 1) + j, b = a + num_t + 1;
      surface.triangles.push_back({a, b, b + 1});
      surface.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return surface;
}

inline TriangleSurface planeSurface(Point<3> const& origin, Point<3> const& u, Point<3> const& v,
                                    int num_u = 8, int num_v = 7)
{
  return gridSurface([=](double s, double t) { return at(origin, s, u, t, v); }, num_u, num_v);
}

// Cells of `size` at all faults, up to `largest`.
inline BuildSettings settings(std::vector<NamedSurface> faults, Box const& box, double size,
                              double largest, TriangleSurface ground = {})
{
  BuildSettings result;
  result.sizes.assign(faults.size(), Field::constant(size));
  result.model = makeModel(std::move(faults), std::move(ground), box, {});
  result.growth = 0.3;
  result.largest = largest;
  result.snap = 0.1 * size;
  result.stub_share = 0.05;
  result.short_share = 0.1;
  return result;
}

inline double areaIn(Complex const& complex, int surface)
{
  double sum = 0;
  for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
    sum += complex.surfaces[i] == surface ? areaOf(complex.points, complex.triangles[i]) : 0;
  }
  return sum;
}

inline double areaOf(GlobalMesh<3> const& mesh, std::string const& name)
{
  double sum = 0;
  for (auto const& facet : mesh.boundaries.at(name)) {
    sum += areaOf(mesh.vertices, facet);
  }
  return sum;
}

// The vertical plane y = 0, 30 km long, to a depth of 15 km.
inline NamedSurface mainFault()
{
  return {"main", planeSurface({-15 * km, 0, 2 * km}, {30 * km, 0, 0}, {0, 0, -17 * km}, 20, 11)};
}

// It crosses `main` at x = 5 km under 60 degrees: 16 km long, to a depth of 15 km.
inline NamedSurface crossingFault()
{
  const double c = 0.5, s = std::sqrt(0.75);
  return {"cross", planeSurface({5 * km - 8 * km * c, -8 * km * s, 2 * km},
                                {16 * km * c, 16 * km * s, 0}, {0, 0, -17 * km}, 11, 11)};
}

// It dips with 60 degrees to `main`, which it meets at a depth of 8 km, and goes on `beyond` [m],
// or stops short if that is negative.
inline NamedSurface splayFault(double beyond)
{
  const double c = 0.5, s = std::sqrt(0.75);
  const Point<3> up = {0, c, s};
  const double length = 8 * km / s + beyond + 1 * km;
  return {"splay", planeSurface(at({-14 * km, 0, -8 * km}, -beyond, up, 0, up), {12 * km, 0, 0},
                                {0, c * length, s * length})};
}

inline Box wideBox() { return {{-35 * km, -27 * km, -30 * km}, {35 * km, 27 * km, 0}}; }

inline GlobalMesh<3> meshOf(Arranged const& arranged, BuildSettings const& given)
{
  return meshArranged(arranged, given, sizeOfCells(arranged, given), [](std::string const&) {});
}
} // namespace asperity::geometry
