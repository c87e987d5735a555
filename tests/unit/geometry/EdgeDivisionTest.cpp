#include "BuiltChecks.hpp"

#include "meshing/CellAngles.hpp"
#include "meshing/EdgeDivision.hpp"

using namespace asperity::geometry;
using asperity::Point;

namespace
{
// Four points of a surface, which is nearly flat, with a cell between its two facets and the
// diagonal that they do not have; above it two points and the cells up to them.
asperity::GlobalMesh<3> flatCellOnASurface()
{
  asperity::GlobalMesh<3> mesh;
  mesh.vertices = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0.02}, {0, 1, 0.02}, {-1, 0, 1.2}, {1, 0, 1.2}};
  mesh.cells = {{0, 1, 3, 2}, {2, 3, 1, 5}, {2, 3, 5, 4}, {2, 3, 4, 0}};
  for (auto& cell : mesh.cells) {
    if (asperity::mesh::signedMeasure(asperity::mesh::corners<3>(mesh.vertices, cell)) < 0) {
      std::swap(cell[0], cell[1]);
    }
  }
  mesh.cell_regions = {0, 0, 0, 0};
  mesh.region_names = {"body"};
  mesh.boundaries["fault"] = {{0, 1, 2}, {0, 1, 3}};
  return mesh;
}

double smallestOf(asperity::GlobalMesh<3> const& mesh)
{
  double smallest = 180;
  for (auto const& cell : mesh.cells) {
    smallest = std::min(smallest, orientedAngle(asperity::mesh::corners<3>(mesh.vertices, cell)));
  }
  return smallest;
}

TEST(EdgeDivision, RepairsACellOfWhichAllVerticesLieOnASurface)
{
  auto mesh = flatCellOnASurface();
  const auto before = mesh;
  ASSERT_LT(smallestOf(mesh), 3);
  EXPECT_EQ(divideEdges(mesh, 8), 1);
  // The diagonal 2-3 gets a vertex: each of the four cells around it becomes two.
  EXPECT_EQ(mesh.vertices.size(), 7u);
  EXPECT_EQ(mesh.cells.size(), 8u);
  EXPECT_EQ(mesh.cell_regions.size(), 8u);
  EXPECT_GT(smallestOf(mesh), 15);
  EXPECT_NEAR(volumeOf(mesh), volumeOf(before), 1e-12);
  EXPECT_EQ(mesh.boundaries, before.boundaries);
  for (std::size_t v = 0; v < before.vertices.size(); ++v) {
    EXPECT_EQ(mesh.vertices[v], before.vertices[v]);
  }
}

TEST(EdgeDivision, LeavesGoodCells)
{
  auto mesh = flatCellOnASurface();
  EXPECT_EQ(divideEdges(mesh, 1), 0);
  EXPECT_EQ(mesh.cells, flatCellOnASurface().cells);
}
} // namespace
