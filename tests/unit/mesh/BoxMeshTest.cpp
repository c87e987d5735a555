#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/generation/BoxMesh.hpp"

using namespace asperity;
using namespace asperity::mesh;

TEST(BoxMesh, IsConformingAndCoversTheBox)
{
  const auto mesh = boxMesh({{3.0, 2.0, 1.0}, {6, 5, 4}, {-1.0, 10.0, -7.0}});
  expectConforming(mesh);
  EXPECT_EQ(mesh.vertices.size(), 7u * 6u * 5u);
  EXPECT_EQ(mesh.cells.size(), 6u * 120u);
  EXPECT_EQ(mesh.vertices.front(), (Point<3>{-1.0, 10.0, -7.0}));
  EXPECT_EQ(mesh.vertices[1], (Point<3>{-0.5, 10.0, -7.0}));
  EXPECT_EQ(mesh.vertices.back(), (Point<3>{2.0, 12.0, -6.0}));
  EXPECT_EQ(mesh.region_names, std::vector<std::string>{"body"});
  const auto sizes = cellSizes(mesh);
  EXPECT_NEAR(sizes.measure, 6.0, 1e-12);
  EXPECT_NEAR(sizes.smallest_diameter, std::sqrt(0.25 + 0.16 + 0.0625), 1e-13);
  EXPECT_NEAR(sizes.largest_diameter, std::sqrt(0.25 + 0.16 + 0.0625), 1e-13);
}

TEST(BoxMesh, NamesItsSides)
{
  const auto mesh = boxMesh({{3.0, 2.0, 1.0}, {3, 4, 5}, {}});
  EXPECT_EQ(mesh.boundaries.size(), 6u);
  char const* const names[3][2] = {{"left", "right"}, {"bottom", "top"}, {"front", "back"}};
  const Point<3> size = {3.0, 2.0, 1.0};
  for (int d = 0; d < 3; ++d) {
    for (int side = 0; side < 2; ++side) {
      Point<3> normal{};
      normal[d] = (side == 0 ? -6.0 : 6.0) / size[d];
      expectNear(integralOfNormal(mesh, names[d][side]), normal, 1e-13, names[d][side]);
      for (int vertex : boundaryVertices(mesh, names[d][side])) {
        EXPECT_EQ(mesh.vertices[vertex][d], side * size[d]);
      }
    }
  }
}

// Around the diagonal of a cube: dihedral angles of 45, 60 and 90 degrees.
TEST(BoxMesh, CutsCubesIntoSixths)
{
  const auto mesh = boxMesh({{2.0, 2.0, 2.0}, {2, 2, 2}, {}});
  EXPECT_NEAR(cellSizes(mesh).smallest_angle, std::atan(1.0), 1e-12);
  for (auto const& cell : mesh.cells) {
    EXPECT_NEAR(signedMeasure(corners(mesh, cell)), 1.0 / 6.0, 1e-15);
    const auto points = corners(mesh, cell);
    EXPECT_EQ(difference<3>(points[3], points[0]), (Point<3>{1.0, 1.0, 1.0}));
  }
}

TEST(BoxMesh, NamesTheParameterThatIsWrong)
{
  test::expectRefusal([] { boxMesh({{-3.0, 1.0, 1.0}, {1, 1, 1}, {}}); }, {"Box / Width = -3"});
  test::expectRefusal([] { boxMesh({{1.0, 0.0, 1.0}, {1, 1, 1}, {}}); }, {"Height = 0"});
  test::expectRefusal([] { boxMesh({{1.0, 1.0, INFINITY}, {1, 1, 1}, {}}); }, {"Depth = inf"});
  test::expectRefusal([] { boxMesh({{1.0, 1.0, 1.0}, {1, 0, 1}, {}}); }, {"Cells Y = 0"});
  test::expectRefusal([] { boxMesh({{1.0, 1.0, 1.0}, {5000, 5000, 5000}, {}}); }, {"too many"});
}
