#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/generation/WedgeMesh.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
GlobalMesh<2> const& thesisMesh()
{
  static const GlobalMesh<2> mesh = wedgeMesh();
  return mesh;
}

double depth(Point<2> const& point) { return dot<2>(point, WedgeShape().gravityDirection()); }
} // namespace

// Pipping 2014, A.1. The total depends on how cells are marked; 6563 there, the fewest here.
TEST(WedgeMesh, HasTheNumbersOfTheThesis)
{
  auto const& mesh = thesisMesh();
  EXPECT_EQ(boundaryVertices(mesh, "base").size(), 262u);
  const auto sizes = cellSizes(mesh);
  EXPECT_NEAR(1e3 * sizes.smallest_diameter, 1.01, 0.005);
  EXPECT_NEAR(1e3 * sizes.largest_diameter, 64.74, 0.005);
  EXPECT_EQ(mesh.vertices.size(), 4789u);
}

TEST(WedgeMesh, IsConformingAndCoversTheWedge)
{
  auto const& mesh = thesisMesh();
  expectConforming(mesh);
  EXPECT_NEAR(cellSizes(mesh).measure, 0.5 * 1.0 * 0.27, 1e-14);
}

TEST(WedgeMesh, LiesOnItsBase)
{
  auto const& mesh = thesisMesh();
  const double th = std::atan(0.27);
  for (int vertex : boundaryVertices(mesh, "base")) {
    EXPECT_EQ(mesh.vertices[vertex][1], 0.0);
  }
  for (int vertex : boundaryVertices(mesh, "surface")) {
    EXPECT_NEAR(depth(mesh.vertices[vertex]), 0.0, 1e-15);
  }
  for (int vertex : boundaryVertices(mesh, "right")) {
    auto const& p = mesh.vertices[vertex];
    EXPECT_NEAR(p[0] * std::cos(th) + p[1] * std::sin(th), 1.0, 1e-14);
  }
  const auto base = integralOfNormal(mesh, "base"), right = integralOfNormal(mesh, "right"),
             surface = integralOfNormal(mesh, "surface");
  EXPECT_NEAR(base[1], -std::sqrt(1.0 + 0.27 * 0.27), 1e-14);
  EXPECT_NEAR(right[0], 0.27 * std::cos(th), 1e-14);
  EXPECT_NEAR(right[1], 0.27 * std::sin(th), 1e-14);
  EXPECT_NEAR(surface[0], -std::sin(th), 1e-14);
  EXPECT_NEAR(surface[1], std::cos(th), 1e-14);
}

// Every cell is no larger than A.1 allows, and around the zone none is larger than m_SZ.
TEST(WedgeMesh, ResolvesTheSeismogenicZone)
{
  auto const& mesh = thesisMesh();
  const WedgeShape shape;
  EXPECT_NEAR(shape.zoneRight() - shape.zoneLeft(), 0.20, 1e-15);
  EXPECT_NEAR(shape.zoneRight(), 0.35 * std::sqrt(1.0 + 0.27 * 0.27), 1e-15);
  int num_cells_at_zone = 0;
  for (auto const& cell : mesh.cells) {
    const auto triangle = corners(mesh, cell);
    double nearest = 1.0;
    for (auto const& p : triangle) {
      const double dx = std::max({shape.zoneLeft() - p[0], p[0] - shape.zoneRight(), 0.0});
      nearest = std::min(nearest, std::hypot(dx, p[1]));
    }
    EXPECT_LE(longestEdge(triangle), (8.0 * nearest / 0.10 + 1.0) * 0.002);
    num_cells_at_zone += nearest == 0.0 ? 1 : 0;
  }
  // Facets of at most 0.002 m cover the 0.20 m, each with a cell: at least 100. Cells with a single
  // vertex there come on top; that they are as many again was chosen after the result.
  EXPECT_GT(num_cells_at_zone, 200);
}

// Along the base, in the middle of a second patch near the back and in the one from the start.
TEST(WedgeMesh, ResolvesFurtherZones)
{
  const auto largest = [](WedgeShape const& shape, double low, double high) {
    const auto mesh = wedgeMesh(shape);
    expectConforming(mesh);
    double size = 0;
    for (auto const& [first, second] : mesh.boundaries.at("base")) {
      const double x = mesh.vertices[first][0], end = mesh.vertices[second][0];
      if (std::max(x, end) > low && std::min(x, end) < high) {
        size = std::max(size, std::abs(end - x));
      }
    }
    return size;
  };
  WedgeShape shape;
  shape.cell_size = 0.01;
  EXPECT_GT(largest(shape, 0.7, 0.8), 0.02);
  shape.further_zones = {{0.7, 0.8}};
  EXPECT_LE(largest(shape, 0.7, 0.8), 0.01);
  EXPECT_LE(largest(shape, shape.zoneLeft(), shape.zoneRight()), 0.01);
  shape.further_zones = {{0.7, 1.1}};
  test::expectRefusal([&] { wedgeMesh(shape); }, {"Refined Intervals", "0.7 to 1.1", "base"});
}

// The region is cut by centroids: its area is that below the plane within a row of cells there.
TEST(WedgeMesh, HasTheViscousRegionAtTheBottom)
{
  auto const& mesh = thesisMesh();
  ASSERT_EQ(mesh.region_names, (std::vector<std::string>{"upper", "lower"}));
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const bool is_low = depth(centroid(corners(mesh, mesh.cells[c]))) > 0.21;
    EXPECT_EQ(mesh.cell_regions[c], is_low ? 1 : 0);
  }
  const double below = 0.5 * 0.06 * 0.06 / 0.27;
  EXPECT_NEAR(measureOf(mesh, 1), below, 0.25 * below);
  EXPECT_NEAR(measureOf(mesh, 0) + measureOf(mesh, 1), 0.135, 1e-14);
}

TEST(WedgeMesh, GrowsCoarserWithTheCellSize)
{
  WedgeShape shape;
  shape.cell_size = 0.02;
  const auto mesh = wedgeMesh(shape);
  expectConforming(mesh);
  EXPECT_LT(mesh.vertices.size(), 500u);
  EXPECT_LE(cellSizes(mesh).smallest_diameter, 0.02);
}

TEST(WedgeMesh, NamesTheParameterThatIsWrong)
{
  const auto expect_refused = [](double WedgeShape::*value, double wrong, std::string const& name) {
    WedgeShape shape;
    shape.*value = wrong;
    test::expectRefusal([&] { wedgeMesh(shape); }, {"Mesh / Wedge / " + name + " = "});
  };
  expect_refused(&WedgeShape::length, 0.0, "Length");
  expect_refused(&WedgeShape::height, -0.27, "Height");
  expect_refused(&WedgeShape::cell_size, 0.0, "Cell Size");
  expect_refused(&WedgeShape::growth_factor, -1.0, "Growth Factor");
  expect_refused(&WedgeShape::growth_length, 0.0, "Growth Length");
  expect_refused(&WedgeShape::zone_end, 1.1, "Seismogenic Zone End");
  expect_refused(&WedgeShape::zone_width, 0.4, "Seismogenic Zone Width");
  expect_refused(&WedgeShape::viscous_thickness, 0.3, "Viscous Thickness");
}

// A subduction zone of 200 km: the same shapes of cells as in the laboratory, sizes in m.
TEST(WedgeMesh, WorksAtTheSizeOfASubductionZone)
{
  WedgeShape shape;
  shape.length = 200e3;
  shape.height = 200e3 * std::tan(std::acos(-1.0) / 12.0);
  shape.zone_width = 120e3;
  shape.zone_end = 150e3;
  shape.cell_size = 1000.0;
  shape.growth_length = 80e3;
  shape.viscous_thickness = 10e3;
  const auto mesh = wedgeMesh(shape);
  expectConforming(mesh);
  const auto sizes = cellSizes(mesh);
  EXPECT_NEAR(sizes.measure / (0.5 * shape.length * shape.height), 1.0, 1e-10);
  EXPECT_NEAR(sizes.smallest_angle, std::acos(-1.0) / 12.0, 1e-10);
  for (auto const& [first, second] : mesh.boundaries.at("base")) {
    const double x = mesh.vertices[first][0], spacing = mesh.vertices[second][0] - x;
    if (x > shape.zoneLeft() && x + spacing < shape.zoneRight()) {
      EXPECT_LE(spacing, shape.cell_size);
    }
  }
  EXPECT_GT(boundaryVertices(mesh, "base").size(), 140u);
  EXPECT_LT(mesh.vertices.size(), 10000u);
}
