#include "MeshSamples.hpp"

#include <limits>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
template <int Dim>
void expectRefused(GlobalMesh<Dim> const& mesh, std::vector<std::string> pieces)
{
  pieces.emplace_back("the file: ");
  test::expectRefusal([&] { checkMesh(mesh, "the file"); }, pieces);
}

// Cells on the unit cube, with these bottoms and one tip.
GlobalMesh<3> cubeUnder(std::vector<std::array<int, 3>> const& bottoms,
                        std::vector<Point<3>> const& more_vertices = {})
{
  auto mesh = cube(); // its top is (4, 5, 7), (4, 6, 7)
  mesh.vertices.push_back({0.5, 0.5, 2.0});
  mesh.vertices.insert(mesh.vertices.end(), more_vertices.begin(), more_vertices.end());
  for (auto const& bottom : bottoms) {
    mesh.cells.push_back({bottom[0], bottom[1], bottom[2], 8});
    mesh.cell_regions.push_back(0);
  }
  return mesh;
}
} // namespace

TEST(GlobalMesh, AcceptsMeshes)
{
  EXPECT_NO_THROW(checkMesh(square(), "square"));
  EXPECT_NO_THROW(checkMesh(cube(), "cube"));
}

TEST(GlobalMesh, NamesInvertedCell)
{
  auto mesh = square();
  std::swap(mesh.cells[1][0], mesh.cells[1][1]);
  expectRefused(mesh, {"cell 1", "(1, 1), (0, 0), (0, 1)", "inverted"});
}

TEST(GlobalMesh, NamesDegenerateCell)
{
  auto mesh = square();
  mesh.vertices[1] = {0.5, 0.5};
  expectRefused(mesh, {"cell 0", "(0, 0), (0.5, 0.5), (1, 1)", "on a line"});
  auto flat = cube();
  flat.vertices[1] = {0.0, 0.0, 0.0};
  expectRefused(flat, {"cell 0", "in a plane"});
}

TEST(GlobalMesh, NamesVertexOutOfRange)
{
  auto mesh = square();
  mesh.cells[1][2] = 4;
  expectRefused(mesh, {"cell 1 has vertex 4, outside [0, 4)"});
  mesh = square();
  mesh.boundaries["top"][0][0] = -1;
  expectRefused(mesh, {"'top' has vertex -1"});
}

TEST(GlobalMesh, NamesRegionOutOfRange)
{
  auto mesh = square();
  mesh.cell_regions[1] = 2;
  expectRefused(mesh, {"cell 1 has region 2, outside [0, 2)"});
  mesh.cell_regions.pop_back();
  expectRefused(mesh, {"regions for 1 cells, but 2 cells"});
}

TEST(GlobalMesh, NamesVertexWithoutCell)
{
  auto mesh = square();
  mesh.vertices.push_back({3.0, 4.0});
  expectRefused(mesh, {"vertex 4 at (3, 4) belongs to no cell"});
}

TEST(GlobalMesh, NamesVertexThatIsNotFinite)
{
  auto mesh = square();
  mesh.vertices[2][1] = std::numeric_limits<double>::quiet_NaN();
  expectRefused(mesh, {"vertex 2", "not finite"});
}

TEST(GlobalMesh, NamesFacetThatIsNone)
{
  auto mesh = square();
  mesh.boundaries["top"] = {{1, 3}};
  expectRefused(mesh, {"'top' with vertices 1, 3 at (1, 0), (0, 1) is not a facet of any cell"});
  mesh.boundaries["top"] = {{2, 3}, {0, 2}};
  expectRefused(mesh, {"'top' has facets inside the body, one at (0.5, 0.5), and on its surface, "
                       "one at (0.5, 1)"});
  mesh.boundaries["top"] = {{0, 2}}; // a fault
  checkMesh(mesh, "test");
  mesh.boundaries["top"] = {{2, 3}, {3, 2}};
  expectRefused(mesh, {"'top'", "twice"});
}

TEST(GlobalMesh, NamesCellsThatShareAFacet)
{
  auto mesh = square();
  mesh.vertices.push_back({0.5, 2.0});
  mesh.cells.push_back({0, 2, 4});
  mesh.cell_regions.push_back(0);
  expectRefused(mesh, {"cells 0, 1 and 2 share the facet with vertices 0, 2"});
}

// Beside the undivided edge from (0, 0) to (1, 1) two cells have a vertex in its middle.
TEST(GlobalMesh, NamesAVertexThatHangsInAnEdge)
{
  auto mesh = square();
  mesh.vertices.push_back({0.5, 0.5});
  mesh.cells = {{0, 1, 2}, {0, 4, 3}, {4, 2, 3}};
  mesh.cell_regions = {0, 1, 1};
  expectRefused(mesh, {"vertex 4 at (0.5, 0.5) m lies inside the edge", "(0, 0)", "(1, 1)",
                       "does not conform"});
  mesh.vertices[4] = {0.45, 0.55}; // a hole
  EXPECT_NO_THROW(checkMesh(mesh, "the file"));
}

TEST(GlobalMesh, NamesFacesOfCellsThatDoNotMatch)
{
  EXPECT_NO_THROW(checkMesh(cubeUnder({{4, 5, 7}, {4, 7, 6}}), "the file"));
  expectRefused(cubeUnder({{4, 5, 6}, {5, 7, 6}}), {"lie on each other and are not the same"});
  expectRefused(cubeUnder({{4, 5, 9}, {5, 7, 9}, {7, 6, 9}, {6, 4, 9}}, {{0.5, 0.5, 1}}),
                {"vertex 9 at (0.5, 0.5, 1) m lies inside the face"});
  expectRefused(cubeUnder({{4, 9, 7}, {9, 5, 7}, {4, 7, 6}}, {{0.5, 0, 1}}),
                {"vertex 9 at (0.5, 0, 1) m lies inside the face"});
}

TEST(GlobalMesh, RefusesAMeshWithoutCells) { expectRefused(GlobalMesh<2>(), {"no cells"}); }

TEST(GlobalMesh, OrientsCellsAndFacets)
{
  auto mesh = square();
  std::swap(mesh.cells[1][0], mesh.cells[1][1]);
  mesh.boundaries["top"] = {{3, 2}};
  EXPECT_EQ(orientCells(mesh), 1);
  EXPECT_EQ(orientCells(mesh), 0);
  orientFacets(mesh);
  checkMesh(mesh, "oriented");
  EXPECT_EQ(mesh.boundaries["top"][0], (std::array<int, 2>{2, 3}));

  auto solid = cube();
  std::swap(solid.cells[4][0], solid.cells[4][1]);
  EXPECT_EQ(orientCells(solid), 1);
  orientFacets(solid);
  checkMesh(solid, "oriented");
  const auto normal = integralOfNormal(solid, "side");
  EXPECT_DOUBLE_EQ(normal[0], -1.0);
  EXPECT_DOUBLE_EQ(normal[1], 0.0);
  EXPECT_DOUBLE_EQ(normal[2], 0.0);
}
