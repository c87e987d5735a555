#pragma once

#include "mesh/GlobalMesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

// Points and simplices in two and three dimensions; lengths in m, areas in m^2 (per metre in 2D:
// m).
namespace asperity::mesh
{
template <int Dim>
Point<Dim> difference(Point<Dim> const& a, Point<Dim> const& b)
{
  Point<Dim> result;
  for (int d = 0; d < Dim; ++d) {
    result[d] = a[d] - b[d];
  }
  return result;
}

template <int Dim>
double dot(Point<Dim> const& a, Point<Dim> const& b)
{
  double sum = 0.0;
  for (int d = 0; d < Dim; ++d) {
    sum += a[d] * b[d];
  }
  return sum;
}

template <int Dim>
double distance(Point<Dim> const& a, Point<Dim> const& b)
{
  const auto edge = difference<Dim>(a, b);
  return std::sqrt(dot<Dim>(edge, edge));
}

inline Point<3> cross(Point<3> const& a, Point<3> const& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Coordinates of the corners of a cell or a facet that crosses no period.
template <int Dim, std::size_t N>
std::array<Point<Dim>, N> corners(std::vector<Point<Dim>> const& vertices,
                                  std::array<int, N> const& simplex)
{
  std::array<Point<Dim>, N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result[i] = vertices[static_cast<std::size_t>(simplex[i])];
  }
  return result;
}

// Coordinates of the corners of a cell or a facet of a Mesh or a GlobalMesh. Along a periodic axis
// corners more than half a period below the highest one are replaced by their images one period
// higher. Thus the cells between the last vertices and the first ones lie where they were before
// these vertices were identified, for every order of their corners.
template <template <int> class AnyMesh, int Dim, std::size_t N>
std::array<Point<Dim>, N> corners(AnyMesh<Dim> const& mesh, std::array<int, N> const& simplex)
{
  auto result = corners<Dim>(mesh.vertices, simplex);
  for (int d = 0; d < Dim; ++d) {
    const double period = mesh.period[d];
    if (period > 0.0) {
      double highest = result[0][d];
      for (auto const& corner : result) {
        highest = std::max(highest, corner[d]);
      }
      for (auto& corner : result) {
        corner[d] += highest - corner[d] > 0.5 * period ? period : 0.0;
      }
    }
  }
  return result;
}

template <std::size_t Dim, std::size_t N>
std::array<double, Dim> centroid(std::array<std::array<double, Dim>, N> const& corners)
{
  std::array<double, Dim> result{};
  for (auto const& corner : corners) {
    for (std::size_t d = 0; d < Dim; ++d) {
      result[d] += corner[d] / static_cast<double>(N);
    }
  }
  return result;
}

// The diameter of a simplex is its longest edge.
template <std::size_t Dim, std::size_t N>
double longestEdge(std::array<std::array<double, Dim>, N> const& corners)
{
  double longest = 0.0;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      longest = std::max(longest, distance<static_cast<int>(Dim)>(corners[i], corners[j]));
    }
  }
  return longest;
}

// Area or volume, negative for an inverted cell.
inline double signedMeasure(std::array<Point<2>, 3> const& c)
{
  const auto a = difference<2>(c[1], c[0]), b = difference<2>(c[2], c[0]);
  return 0.5 * (a[0] * b[1] - a[1] * b[0]);
}
inline double signedMeasure(std::array<Point<3>, 4> const& c)
{
  const auto a = difference<3>(c[1], c[0]), b = difference<3>(c[2], c[0]);
  return dot<3>(cross(a, b), difference<3>(c[3], c[0])) / 6.0;
}

// The normal of a facet, whose length is the size of the facet; outward if the orientation is.
inline Point<2> areaNormal(std::array<Point<2>, 2> const& c)
{
  return {c[1][1] - c[0][1], c[0][0] - c[1][0]};
}
inline Point<3> areaNormal(std::array<Point<3>, 3> const& c)
{
  const auto normal = cross(difference<3>(c[1], c[0]), difference<3>(c[2], c[0]));
  return {0.5 * normal[0], 0.5 * normal[1], 0.5 * normal[2]};
}

// Length or area of a facet.
template <std::size_t Dim>
double facetMeasure(std::array<std::array<double, Dim>, Dim> const& corners)
{
  const auto normal = areaNormal(corners);
  return std::sqrt(dot<static_cast<int>(Dim)>(normal, normal));
}

// Unit normal, outward if the facet's orientation is.
template <std::size_t Dim>
std::array<double, Dim> facetNormal(std::array<std::array<double, Dim>, Dim> const& corners)
{
  auto normal = areaNormal(corners);
  const double measure = facetMeasure(corners);
  for (double& component : normal) {
    component /= measure;
  }
  return normal;
}
} // namespace asperity::mesh
