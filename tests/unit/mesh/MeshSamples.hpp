#pragma once

#include "mesh/GlobalMesh.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/detail/FacetTable.hpp"
#include "mesh/generation/WedgeMesh.hpp"
#include "unit/base/Refusal.hpp"

#include <gtest/gtest.h>

#include <string>

namespace asperity::mesh
{
// The unit square in two triangles, with a diagonal from (0, 0) to (1, 1).
inline GlobalMesh<2> square()
{
  GlobalMesh<2> mesh;
  mesh.vertices = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  mesh.cells = {{0, 1, 2}, {0, 2, 3}};
  mesh.cell_regions = {0, 1};
  mesh.region_names = {"right of it", "left of it"};
  mesh.boundaries = {{"bottom", {{0, 1}}}, {"top", {{2, 3}}}};
  return mesh;
}

// Triangles of all sizes and shapes that the wedge has, of at most this size [m] at the zone.
inline GlobalMesh<2> coarseWedge(double cell_size)
{
  WedgeShape shape;
  shape.cell_size = cell_size;
  return wedgeMesh(shape);
}

// The unit cube in six tetrahedra around its diagonal; `side` is x = 0.
inline GlobalMesh<3> cube()
{
  GlobalMesh<3> mesh;
  for (int v = 0; v < 8; ++v) {
    mesh.vertices.push_back({double(v & 1), double((v >> 1) & 1), double((v >> 2) & 1)});
  }
  mesh.cells = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  mesh.cell_regions.assign(6, 0);
  mesh.region_names = {"rock"};
  mesh.boundaries = {{"side", {{0, 2, 6}, {0, 4, 6}}}};
  return mesh;
}

// Every facet in two cells, or in one and then in exactly one boundary with outward orientation;
// all boundaries together are the mesh's boundary.
template <int Dim>
void expectConforming(GlobalMesh<Dim> const& mesh)
{
  checkMesh(mesh, "test");
  const detail::FacetTable<Dim> table(mesh.cells);
  std::size_t num_named = 0;
  for (auto const& [name, facets] : mesh.boundaries) {
    num_named += facets.size();
    for (auto const& facet : facets) {
      const auto outward = table.find(facet).first->outward;
      EXPECT_GT(dot<Dim>(areaNormal(corners(mesh, facet)), areaNormal(corners(mesh, outward))), 0.0)
        << name;
    }
  }
  EXPECT_EQ(table.outerEntries().size(), num_named);
}

template <int Dim>
void expectEqual(GlobalMesh<Dim> const& mesh, GlobalMesh<Dim> const& other)
{
  EXPECT_EQ(mesh.vertices, other.vertices);
  EXPECT_EQ(mesh.period, other.period);
  EXPECT_EQ(mesh.cells, other.cells);
  EXPECT_EQ(mesh.cell_regions, other.cell_regions);
  EXPECT_EQ(mesh.region_names, other.region_names);
  EXPECT_EQ(mesh.boundaries, other.boundaries);
  EXPECT_EQ(mesh.splits, other.splits);
  EXPECT_EQ(mesh.faults, other.faults);
}

template <std::size_t Dim>
void expectNear(std::array<double, Dim> const& point, std::array<double, Dim> const& wanted,
                double tolerance, std::string const& what)
{
  for (std::size_t d = 0; d < Dim; ++d) {
    EXPECT_NEAR(point[d], wanted[d], tolerance) << what;
  }
}

template <int Dim>
double measureOf(GlobalMesh<Dim> const& mesh, int region)
{
  double sum = 0.0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    if (mesh.cell_regions[c] == region) {
      sum += signedMeasure(corners(mesh, mesh.cells[c]));
    }
  }
  return sum;
}

// Outward normal times measure, summed over a boundary.
template <int Dim>
Point<Dim> integralOfNormal(GlobalMesh<Dim> const& mesh, std::string const& boundary)
{
  Point<Dim> sum{};
  for (auto const& facet : mesh.boundaries.at(boundary)) {
    const auto normal = areaNormal(corners(mesh, facet));
    for (int d = 0; d < Dim; ++d) {
      sum[d] += normal[d];
    }
  }
  return sum;
}
} // namespace asperity::mesh
