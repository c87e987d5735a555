#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/generation/ExtrudedMesh.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
const std::vector<double> uneven = {-0.5, -0.3, 0.1, 0.2};
} // namespace

TEST(ExtrudedMesh, IsConformingAndInheritsRegionsAndBoundaries)
{
  const auto plane = coarseWedge(0.04);
  const auto mesh = extrude(plane, uneven);
  expectConforming(mesh);
  EXPECT_EQ(mesh.vertices.size(), 4 * plane.vertices.size());
  EXPECT_EQ(mesh.cells.size(), 9 * plane.cells.size());
  EXPECT_EQ(mesh.region_names, plane.region_names);
  for (int region : {0, 1}) {
    EXPECT_NEAR(measureOf(mesh, region), 0.7 * measureOf(plane, region), 1e-14);
  }
  for (char const* name : {"base", "right", "surface"}) {
    const auto normal = integralOfNormal(plane, name);
    const Point<3> wanted = {0.7 * normal[0], 0.7 * normal[1], 0.0};
    expectNear(integralOfNormal(mesh, name), wanted, 1e-14, name);
  }
}

TEST(ExtrudedMesh, HasAFrontAndABack)
{
  const auto plane = coarseWedge(0.04);
  const auto mesh = extrude(plane, uneven);
  EXPECT_NEAR(integralOfNormal(mesh, "front")[2], -0.135, 1e-14);
  EXPECT_NEAR(integralOfNormal(mesh, "back")[2], 0.135, 1e-14);
  for (int vertex : boundaryVertices(mesh, "back")) {
    EXPECT_EQ(mesh.vertices[vertex][2], 0.2);
  }
  const auto num_vertices = static_cast<int>(plane.vertices.size());
  for (std::size_t f = 0; f < plane.cells.size(); ++f) {
    auto const& [i, j, k] = mesh.boundaries.at("front")[f];
    EXPECT_EQ((GlobalMesh<2>::Cell{i, k, j}), plane.cells[f]);
    EXPECT_EQ(mesh.boundaries.at("back")[f][0], plane.cells[f][0] + 3 * num_vertices);
  }
}

// Layer k is layer 0 with all numbers larger by k times the plane's: so are its diagonals.
TEST(ExtrudedMesh, HasTheSamePatternInEveryLayer)
{
  const auto plane = coarseWedge(0.04);
  const auto mesh = extrude(plane, uneven);
  const std::size_t in_layer = 3 * plane.cells.size();
  const auto num_vertices = static_cast<int>(plane.vertices.size());
  for (std::size_t c = 0; c < in_layer; ++c) {
    for (int k = 1; k < 3; ++k) {
      for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(mesh.cells[k * in_layer + c][i], mesh.cells[c][i] + k * num_vertices);
      }
    }
  }
}

TEST(ExtrudedMesh, RefusesLevelsThatAreNone)
{
  auto plane = square();
  test::expectRefusal([&] { extrude(plane, {0.0}); }, {"at least 2 levels, not 1"});
  test::expectRefusal([&] { extrude(plane, {0.0, 1.0, 1.0}); }, {"ascend", "number 2 is at 1 m"});
  test::expectRefusal([&] { extrude(plane, {0.0, NAN}); }, {"ascend", "number 1"});
  plane.boundaries["back"] = {{0, 1}};
  test::expectRefusal([&] { extrude(plane, {0.0, 1.0}); }, {"boundary 'back'"});
}

TEST(ExtrudedMesh, SpacesLevelsEqually)
{
  EXPECT_EQ(equalLevels(3.0, 4), (std::vector<double>{0.0, 0.75, 1.5, 2.25, 3.0}));
}
