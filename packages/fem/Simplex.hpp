#pragma once

#include "mesh/SimplexGeometry.hpp"

#include <array>

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

// The gradient of a barycentric coordinate is the inward area normal of the facet opposite its
// vertex, divided by Dim times the measure.
inline std::array<Point<2>, 3> oppositeNormals(std::array<Point<2>, 3> const& c)
{
  return {mesh::areaNormal({c[2], c[1]}), mesh::areaNormal({c[0], c[2]}),
          mesh::areaNormal({c[1], c[0]})};
}
inline std::array<Point<3>, 4> oppositeNormals(std::array<Point<3>, 4> const& c)
{
  return {mesh::areaNormal({c[1], c[3], c[2]}), mesh::areaNormal({c[0], c[2], c[3]}),
          mesh::areaNormal({c[0], c[3], c[1]}), mesh::areaNormal({c[0], c[1], c[2]})};
}

template <int Dim>
Simplex<Dim> simplexOf(Mesh<Dim> const& mesh, int cell)
{
  auto const corners = mesh::corners(mesh, mesh.cells[cell]);
  Simplex<Dim> simplex;
  simplex.measure = mesh::signedMeasure(corners);
  simplex.centroid = mesh::centroid(corners);
  simplex.gradients = oppositeNormals(corners);
  for (auto& gradient : simplex.gradients) {
    for (double& component : gradient) {
      component /= Dim * simplex.measure;
    }
  }
  return simplex;
}
} // namespace asperity::fem
