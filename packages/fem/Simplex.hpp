#pragma once

#include "mesh/Mesh.hpp"

#include <array>
#include <cmath>

namespace asperity::fem
{
// Measure and gradients of the barycentric coordinates of a simplex; both are constant over it.
template <int Dim>
struct Simplex
{
  double measure = 0;                          // m^Dim, positive for a positively oriented cell
  std::array<Point<Dim>, Dim + 1> gradients{}; // 1/m
  Point<Dim> centroid{};
};

template <int Dim>
Simplex<Dim> simplexOf(Mesh<Dim> const& mesh, int cell);

template <>
inline Simplex<2> simplexOf<2>(Mesh<2> const& mesh, int cell)
{
  auto const& nodes = mesh.cells[cell];
  auto const& p = mesh.vertices[nodes[0]];
  auto const& q = mesh.vertices[nodes[1]];
  auto const& r = mesh.vertices[nodes[2]];
  const double twice = (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
  Simplex<2> simplex;
  simplex.measure = twice / 2;
  simplex.gradients[0] = {(q[1] - r[1]) / twice, (r[0] - q[0]) / twice};
  simplex.gradients[1] = {(r[1] - p[1]) / twice, (p[0] - r[0]) / twice};
  simplex.gradients[2] = {(p[1] - q[1]) / twice, (q[0] - p[0]) / twice};
  simplex.centroid = {(p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3};
  return simplex;
}

template <>
inline Simplex<3> simplexOf<3>(Mesh<3> const& mesh, int cell)
{
  auto const& nodes = mesh.cells[cell];
  Point<3> const& p = mesh.vertices[nodes[0]];
  std::array<Point<3>, 3> edge{};
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) {
      edge[k][i] = mesh.vertices[nodes[k + 1]][i] - p[i];
    }
  }
  auto const cross = [](Point<3> const& a, Point<3> const& b) {
    return Point<3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0]};
  };
  Simplex<3> simplex;
  auto const face = cross(edge[1], edge[2]);
  const double six = edge[0][0] * face[0] + edge[0][1] * face[1] + edge[0][2] * face[2];
  simplex.measure = six / 6;
  const std::array<Point<3>, 3> faces = {face, cross(edge[2], edge[0]), cross(edge[0], edge[1])};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      simplex.gradients[k + 1][i] = faces[k][i] / six;
      simplex.gradients[0][i] -= faces[k][i] / six;
    }
    simplex.centroid[i] = p[i] + (edge[0][i] + edge[1][i] + edge[2][i]) / 4;
  }
  return simplex;
}

// Area-weighted outward normal of a boundary facet of a body: its length is the facet's measure
// [m^(Dim-1)].
template <int Dim>
Point<Dim> facetNormal(Mesh<Dim> const& mesh, typename Mesh<Dim>::Facet const& facet);

template <>
inline Point<2> facetNormal<2>(Mesh<2> const& mesh, Mesh<2>::Facet const& facet)
{
  auto const& p = mesh.vertices[facet[0]];
  auto const& q = mesh.vertices[facet[1]];
  return {q[1] - p[1], p[0] - q[0]};
}

template <>
inline Point<3> facetNormal<3>(Mesh<3> const& mesh, Mesh<3>::Facet const& facet)
{
  auto const& p = mesh.vertices[facet[0]];
  auto const& q = mesh.vertices[facet[1]];
  auto const& r = mesh.vertices[facet[2]];
  const Point<3> a = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  const Point<3> b = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  return {(a[1] * b[2] - a[2] * b[1]) / 2, (a[2] * b[0] - a[0] * b[2]) / 2,
          (a[0] * b[1] - a[1] * b[0]) / 2};
}

template <int Dim>
double length(Point<Dim> const& vector)
{
  double square = 0;
  for (double x : vector) {
    square += x * x;
  }
  return std::sqrt(square);
}
} // namespace asperity::fem
