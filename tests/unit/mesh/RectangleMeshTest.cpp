#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/generation/RectangleMesh.hpp"

using namespace asperity;
using namespace asperity::mesh;

TEST(RectangleMesh, IsConformingAndCoversTheRectangle)
{
  const RectangleShape shape{3.0, 2.0, 6, 5, {-1.0, 10.0}};
  const auto mesh = rectangleMesh(shape);
  expectConforming(mesh);
  EXPECT_EQ(mesh.vertices.size(), 42u);
  EXPECT_EQ(mesh.cells.size(), 60u);
  EXPECT_EQ(mesh.vertices.front(), (Point<2>{-1.0, 10.0}));
  EXPECT_EQ(mesh.vertices.back(), (Point<2>{2.0, 12.0}));
  EXPECT_EQ(mesh.region_names, std::vector<std::string>{"body"});
  const auto sizes = cellSizes(mesh);
  EXPECT_NEAR(sizes.measure, 6.0, 1e-13);
  EXPECT_NEAR(sizes.smallest_diameter, std::hypot(0.5, 0.4), 1e-13);
  EXPECT_NEAR(sizes.largest_diameter, std::hypot(0.5, 0.4), 1e-13);
}

TEST(RectangleMesh, NamesItsSides)
{
  const auto mesh = rectangleMesh({3.0, 2.0, 6, 5, {0.0, 0.0}});
  EXPECT_EQ(mesh.boundaries.size(), 4u);
  const std::map<std::string, Point<2>> normals = {
    {"bottom", {0.0, -3.0}}, {"top", {0.0, 3.0}}, {"left", {-2.0, 0.0}}, {"right", {2.0, 0.0}}};
  for (auto const& [name, normal] : normals) {
    expectNear(integralOfNormal(mesh, name), normal, 1e-14, name);
  }
  for (int vertex : boundaryVertices(mesh, "left")) {
    EXPECT_EQ(mesh.vertices[vertex][0], 0.0);
  }
  for (int vertex : boundaryVertices(mesh, "top")) {
    EXPECT_EQ(mesh.vertices[vertex][1], 2.0);
  }
}

// With alternating diagonals the vertices inside have four or eight cells, in turns.
TEST(RectangleMesh, AlternatesItsDiagonals)
{
  const auto mesh = rectangleMesh({1.0, 1.0, 4, 4, {0.0, 0.0}});
  std::vector<int> num_cells(mesh.vertices.size(), 0);
  for (auto const& cell : mesh.cells) {
    for (int vertex : cell) {
      ++num_cells[vertex];
    }
  }
  for (int j = 1; j < 4; ++j) {
    for (int i = 1; i < 4; ++i) {
      EXPECT_EQ(num_cells[5 * j + i], (i + j) % 2 == 0 ? 8 : 4);
    }
  }
}

TEST(RectangleMesh, NamesTheParameterThatIsWrong)
{
  test::expectRefusal(
    [] {
      rectangleMesh({-3.0, 1.0, 1, 1, {}});
    },
    {"Mesh / Rectangle / Width = -3"});
  test::expectRefusal([] { rectangleMesh({1.0, 0.0, 1, 1, {}}); }, {"Height = 0"});
  test::expectRefusal([] { rectangleMesh({1.0, 1.0, 0, 1, {}}); }, {"Cells X = 0"});
  test::expectRefusal([] { rectangleMesh({1.0, 1.0, 1, -2, {}}); }, {"Cells Y = -2"});
  test::expectRefusal([] { rectangleMesh({1.0, 1.0, 100000, 100000, {}}); }, {"too many"});
}
