#pragma once

#include "SampleSurfaces.hpp"

#include "building/BuildReport.hpp"
#include "meshing/CellEstimate.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <gtest/gtest.h>

#include <map>

namespace asperity::geometry
{
inline double volumeOf(GlobalMesh<3> const& mesh)
{
  double sum = 0;
  for (auto const& cell : mesh.cells) {
    const auto x = mesh::corners<3>(mesh.vertices, cell);
    sum +=
      mesh::dot<3>(mesh::difference<3>(x[3], x[0]),
                   mesh::cross(mesh::difference<3>(x[1], x[0]), mesh::difference<3>(x[2], x[0]))) /
      6;
  }
  return sum;
}

// Every outer face has one name and a fault's facet two cells; nothing else has a name.
inline void expectNames(GlobalMesh<3> const& mesh, Model const& model)
{
  std::map<Triangle, int> cells, names;
  const auto key = [](int a, int b, int c) {
    Triangle face = {a, b, c};
    std::sort(face.begin(), face.end());
    return face;
  };
  for (auto const& c : mesh.cells) {
    for (auto const& face : {key(c[0], c[1], c[2]), key(c[0], c[1], c[3]), key(c[0], c[2], c[3]),
                             key(c[1], c[2], c[3])}) {
      ++cells[face];
    }
  }
  for (int s = 0; s < static_cast<int>(model.surfaces.size()); ++s) {
    auto const& facets = mesh.boundaries.at(model.name(s));
    EXPECT_FALSE(facets.empty()) << model.name(s);
    for (auto const& facet : facets) {
      const auto face = key(facet[0], facet[1], facet[2]);
      EXPECT_EQ(cells.at(face), model.isFault(s) ? 2 : 1) << model.name(s);
      EXPECT_EQ(++names[face], 1) << model.name(s);
    }
  }
  std::size_t num_unnamed = 0;
  for (auto const& [face, number] : cells) {
    num_unnamed += number == 1 && names.count(face) == 0 ? 1 : 0;
  }
  EXPECT_EQ(num_unnamed, 0u);
}

// No dihedral angle below 5 degrees, unless surfaces meet below 15.
inline void expectAngles(GlobalMesh<3> const& mesh, Arranged const& arranged, Model const& model)
{
  const auto between = smallestAngle(arranged.complex, model);
  const auto smallest = smallestAngles(mesh, 1).front();
  if (between.degrees >= 15) {
    EXPECT_GE(smallest.degrees, 5) << "at " << placeText(smallest.place);
  }
}

// The number of cells that was expected before.
inline void expectEstimate(GlobalMesh<3> const& mesh, Arranged const& arranged,
                           BuildSettings const& given)
{
  const auto expected = expectedCells(arranged.complex, given.model, sizeOfCells(arranged, given));
  const auto cells = double(mesh.cells.size()), vertices = double(mesh.vertices.size());
  EXPECT_LT(std::max(expected.cells / cells, cells / expected.cells), estimate_factor) << cells;
  EXPECT_LT(std::max(expected.vertices / vertices, vertices / expected.vertices), estimate_factor)
    << vertices;
}
} // namespace asperity::geometry
