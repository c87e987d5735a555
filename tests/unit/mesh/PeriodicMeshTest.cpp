#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/ExtrudedMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "mesh/parallel/Partition.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
GlobalMesh<3> box(int layers = 4) { return boxMesh({{1.0, 2.0, 4.0}, {2, 3, layers}, {0, 0, -1}}); }

GlobalMesh<3> periodicBox()
{
  auto mesh = box();
  makePeriodic(mesh, 2, "front", "back");
  return mesh;
}
} // namespace

TEST(PeriodicMesh, IdentifiesTheVerticesOfOppositeSides)
{
  const auto before = box(), mesh = periodicBox();
  expectConforming(mesh);
  EXPECT_EQ(mesh.period, (Point<3>{0.0, 0.0, 4.0}));
  EXPECT_EQ(mesh.vertices.size(), before.vertices.size() - 12);
  EXPECT_EQ(mesh.cells.size(), before.cells.size());
  EXPECT_EQ(mesh.boundaries.size(), 4u);
  EXPECT_EQ(mesh.boundaries.count("front") + mesh.boundaries.count("back"), 0u);
  for (auto const& vertex : mesh.vertices) {
    EXPECT_LT(vertex[2], 3.0);
  }
}

// Cells and facets lie where they did.
TEST(PeriodicMesh, KeepsTheGeometry)
{
  const auto before = box(), mesh = periodicBox();
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    EXPECT_EQ(corners(mesh, mesh.cells[c]), corners(before, before.cells[c]));
  }
  for (auto const& [name, facets] : mesh.boundaries) {
    EXPECT_EQ(integralOfNormal(mesh, name), integralOfNormal(before, name)) << name;
  }
  EXPECT_NEAR(cellSizes(mesh).measure, 8.0, 1e-13);
  EXPECT_EQ(cellSizes(mesh).largest_diameter, cellSizes(before).largest_diameter);
}

// A vertex of the two sides is like those inside: as many cells, and a whole ball around it.
TEST(PeriodicMesh, HasNoSideAnyMore)
{
  const auto mesh = periodicBox();
  std::vector<double> measures(mesh.vertices.size(), 0.0);
  for (auto const& cell : mesh.cells) {
    for (int vertex : cell) {
      measures[vertex] += signedMeasure(corners(mesh, cell));
    }
  }
  for (std::size_t v = 0; v < measures.size(); ++v) {
    EXPECT_NEAR(measures[v], measures[v % 12], 1e-14);
  }
}

TEST(PeriodicMesh, MayBePeriodicAlongEveryAxis)
{
  auto mesh = boxMesh({{1.0, 2.0, 4.0}, {3, 4, 5}, {}});
  makePeriodic(mesh, 2, "front", "back");
  makePeriodic(mesh, 0, "left", "right");
  makePeriodic(mesh, 1, "bottom", "top");
  EXPECT_EQ(mesh.period, (Point<3>{1.0, 2.0, 4.0}));
  EXPECT_EQ(mesh.vertices.size(), 60u);
  EXPECT_TRUE(mesh.boundaries.empty());
  expectConforming(mesh);
  EXPECT_NEAR(cellSizes(mesh).measure, 8.0, 1e-13);
}

TEST(PeriodicMesh, WorksInThePlaneAndSurvivesExtrusion)
{
  auto plane = rectangleMesh({3.0, 1.0, 5, 2, {7.0, 0.0}});
  makePeriodic(plane, 0, "left", "right");
  expectConforming(plane);
  EXPECT_EQ(plane.period, (Point<2>{3.0, 0.0}));
  EXPECT_NEAR(cellSizes(plane).measure, 3.0, 1e-14);
  const auto mesh = extrude(plane, {0.0, 1.0, 2.0});
  EXPECT_EQ(mesh.period, (Point<3>{3.0, 0.0, 0.0}));
  expectConforming(mesh);
  EXPECT_NEAR(cellSizes(mesh).measure, 6.0, 1e-14);
}

// Corners of a rank's part are those of the whole mesh.
TEST(PeriodicMesh, IsDistributedWithItsPeriod)
{
  const auto mesh = periodicBox();
  const auto owners = partitionVertices(mesh, 3);
  double measure = 0.0;
  for (int rank = 0; rank < 3; ++rank) {
    const auto part = localPart(mesh, owners, rank);
    EXPECT_EQ(part.period, mesh.period);
    for (auto const& cell : part.cells) {
      measure += cell[0] < part.num_owned ? signedMeasure(corners(part, cell)) : 0.0;
    }
  }
  EXPECT_NEAR(measure, 8.0, 1e-13);
}

TEST(PeriodicMesh, RefusesSidesThatAreNoTranslates)
{
  auto moved = box();
  moved.vertices.back()[0] += 0.1;
  test::expectRefusal([&] { makePeriodic(moved, 2, "front", "back"); },
                      {"'front' and 'back'", "(1.1, 2, 3)", "translates"});
  auto fewer = box();
  fewer.boundaries["back"].resize(2);
  test::expectRefusal([&] { makePeriodic(fewer, 2, "front", "back"); }, {"12 and 4 vertices"});
  auto turned = box(); // the facets of the back lead over the same vertices, but other ones
  turned.boundaries["back"] = turned.boundaries["front"];
  for (auto& facet : turned.boundaries["back"]) {
    for (int& vertex : facet) {
      vertex = 48 + (vertex % 12 + 1) % 12;
    }
  }
  test::expectRefusal([&] { makePeriodic(turned, 2, "front", "back"); }, {"not their facets"});
  auto mesh = box();
  test::expectRefusal([&] { makePeriodic(mesh, 2, "back", "front"); }, {"Swap them"});
  test::expectRefusal([&] { makePeriodic(mesh, 2, "front", "bock"); }, {"Did you mean 'back'"});
}

TEST(PeriodicMesh, RefusesFewerThanThreeCells)
{
  for (int layers : {1, 2}) {
    auto mesh = box(layers);
    test::expectRefusal([&] { makePeriodic(mesh, 2, "front", "back"); },
                        {"'front' and 'back'", "At least 3 cells"});
  }
  auto mesh = box(3);
  makePeriodic(mesh, 2, "front", "back");
  expectConforming(mesh);
}

TEST(PeriodicMesh, ChecksPeriodsOfMeshes)
{
  auto mesh = square();
  mesh.period[1] = -2.0;
  test::expectRefusal([&] { checkMesh(mesh, "here"); }, {"here", "period along y", "-2"});
}
