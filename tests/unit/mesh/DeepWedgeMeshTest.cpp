#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/WedgeMesh.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
WedgeShape coarseShape()
{
  WedgeShape shape;
  shape.cell_size = 0.016;
  return shape;
}

// Of the nearest corner from the seismogenic zone where z is in one of the intervals.
template <class Corners>
double cornerDistance(Corners const& corners, std::vector<std::array<double, 2>> const& patches)
{
  const WedgeShape shape;
  double nearest = 10.0;
  for (auto const& p : corners) {
    const double dx = std::max({shape.zoneLeft() - p[0], p[0] - shape.zoneRight(), 0.0});
    for (auto const& [low, high] : patches) {
      const double dz = std::max({low - p[2], p[2] - high, 0.0});
      nearest = std::min(nearest, std::hypot(dx, p[1], dz));
    }
  }
  return nearest;
}

int expectGraded(GlobalMesh<3> const& mesh, std::vector<std::array<double, 2>> const& patches)
{
  int num_cells_at_zone = 0;
  for (auto const& cell : mesh.cells) {
    const auto points = corners(mesh, cell);
    const double nearest = cornerDistance(points, patches);
    EXPECT_LE(longestEdge(points), 1.000001 * (8.0 * nearest / 0.10 + 1.0) * 0.016);
    num_cells_at_zone += nearest == 0.0 ? 1 : 0;
  }
  return num_cells_at_zone;
}
} // namespace

TEST(DeepWedgeMesh, IsConformingAndCoversTheWedge)
{
  for (double depth : {0.1, 0.6}) {
    const auto mesh = deepWedgeMesh(coarseShape(), {depth, {}, false});
    expectConforming(mesh);
    EXPECT_NEAR(cellSizes(mesh).measure, 0.135 * depth, 1e-13);
    EXPECT_EQ(mesh.boundaries.size(), 5u);
    EXPECT_NEAR(integralOfNormal(mesh, "base")[1], -depth * std::hypot(1.0, 0.27), 1e-13);
    EXPECT_NEAR(integralOfNormal(mesh, "front")[2], -0.135, 1e-13);
    EXPECT_NEAR(integralOfNormal(mesh, "back")[2], 0.135, 1e-13);
    const double th = std::atan(0.27);
    EXPECT_NEAR(integralOfNormal(mesh, "surface")[1], depth * std::cos(th), 1e-13);
    EXPECT_NEAR(integralOfNormal(mesh, "right")[0], 0.27 * depth * std::cos(th), 1e-13);
    for (int vertex : boundaryVertices(mesh, "base")) {
      EXPECT_EQ(mesh.vertices[vertex][1], 0.0);
    }
  }
}

TEST(DeepWedgeMesh, IsGradedInAllDirections)
{
  const auto mesh = deepWedgeMesh(coarseShape(), {0.1, {}, false});
  EXPECT_GT(expectGraded(mesh, {{0.0, 0.1}}), 500);
  EXPECT_LT(mesh.vertices.size(), 3000u);
}

// Two patches side by side: no larger cells than wanted, and on the base between them and beside
// them larger ones than on them.
TEST(DeepWedgeMesh, RefinesItsPatchesOnly)
{
  const std::vector<std::array<double, 2>> patches = {{0.05, 0.25}, {0.45, 0.55}};
  const auto mesh = deepWedgeMesh(coarseShape(), {0.6, patches, false});
  const auto whole = deepWedgeMesh(coarseShape(), {0.6, {}, false});
  EXPECT_GT(expectGraded(mesh, patches), 1000);
  EXPECT_LT(4 * mesh.vertices.size(), 3 * whole.vertices.size());
  double smallest_between = 1.0;
  for (auto const& facet : mesh.boundaries.at("base")) {
    const double z = centroid(corners(mesh, facet))[2];
    if (z > 0.34 && z < 0.36) {
      smallest_between = std::min(smallest_between, longestEdge(corners(mesh, facet)));
    }
  }
  EXPECT_GT(smallest_between, 0.03);
}

TEST(DeepWedgeMesh, RefinesFurtherZones)
{
  const auto largest = [](WedgeShape const& shape) {
    const auto mesh = deepWedgeMesh(shape, {0.1, {}, false});
    double size = 0.0;
    for (auto const& facet : mesh.boundaries.at("base")) {
      const double x = centroid(corners(mesh, facet))[0];
      size = x > 0.7 && x < 0.8 ? std::max(size, longestEdge(corners(mesh, facet))) : size;
    }
    return size;
  };
  auto shape = coarseShape();
  EXPECT_GT(largest(shape), 2.0 * shape.cell_size);
  shape.further_zones = {{0.7, 0.8}};
  EXPECT_LE(largest(shape), (1.0 + 1e-8) * shape.cell_size);
}

// Bisection begins with prisms that are about as long as wide: the smallest angle of the wedge, th,
// stays the smallest one nearly.
TEST(DeepWedgeMesh, HasGoodShapes)
{
  const double degree = std::atan(1.0) / 45.0;
  for (double depth : {0.1, 0.3, 0.6, 2.0}) {
    const auto mesh = deepWedgeMesh(coarseShape(), {depth, {{0.0, 0.1}}, false});
    EXPECT_GT(cellSizes(mesh).smallest_angle, 12.0 * degree) << depth;
  }
}

TEST(DeepWedgeMesh, HasTheViscousRegionAtTheBottom)
{
  const auto mesh = deepWedgeMesh(coarseShape(), {0.1, {}, false});
  ASSERT_EQ(mesh.region_names, (std::vector<std::string>{"upper", "lower"}));
  const auto down = WedgeShape().gravityDirection();
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto centre = centroid(corners(mesh, mesh.cells[c]));
    const bool is_low = centre[0] * down[0] + centre[1] * down[1] > 0.21;
    EXPECT_EQ(mesh.cell_regions[c], is_low ? 1 : 0);
  }
  EXPECT_GT(measureOf(mesh, 1), 0.0);
}

TEST(DeepWedgeMesh, MayBePeriodic)
{
  const auto mesh = deepWedgeMesh(coarseShape(), {0.3, {{0.0, 0.1}}, true});
  expectConforming(mesh);
  EXPECT_EQ(mesh.period, (Point<3>{0.0, 0.0, 0.3}));
  EXPECT_EQ(mesh.boundaries.size(), 3u);
  EXPECT_NEAR(cellSizes(mesh).measure, 0.135 * 0.3, 1e-13);
  expectGraded(mesh, {{-0.3, -0.2}, {0.0, 0.1}, {0.3, 0.4}});
}

TEST(DeepWedgeMesh, IsThePlaneWedgeInLayers)
{
  const auto plane = wedgeMesh(coarseShape());
  auto mesh = layeredWedgeMesh(coarseShape(), 0.1, 5);
  expectConforming(mesh);
  EXPECT_EQ(mesh.vertices.size(), 6 * plane.vertices.size());
  EXPECT_NEAR(cellSizes(mesh).measure, 0.0135, 1e-14);
  EXPECT_NEAR(measureOf(mesh, 1), 0.1 * measureOf(plane, 1), 1e-14);
  EXPECT_EQ(boundaryVertices(mesh, "base").size(), 6 * boundaryVertices(plane, "base").size());
  makePeriodic(mesh, 2, "front", "back");
  expectConforming(mesh);
  EXPECT_NEAR(mesh.period[2], 0.1, 1e-15);
}

TEST(DeepWedgeMesh, NamesTheParameterThatIsWrong)
{
  const auto expect_refused = [](DeepWedge const& deep, std::vector<std::string> const& pieces) {
    test::expectRefusal([&] { deepWedgeMesh(coarseShape(), deep); }, pieces);
  };
  expect_refused({0.0, {}, false}, {"Wedge / Depth = 0"});
  expect_refused({1e20, {}, false}, {"vertices are too many", "cell size"});
  expect_refused({0.6, {{0.0, 0.2}, {0.5, 0.7}}, false},
                 {"Wedge / Seismogenic Intervals", "0.5 to 0.7", "0.6"});
  expect_refused({0.6, {{0.2, 0.2}}, false}, {"Wedge / Seismogenic Intervals", "0.2 to 0.2"});
  WedgeShape flat = coarseShape();
  flat.height = 0.0;
  test::expectRefusal([&] { deepWedgeMesh(flat, {}); }, {"Wedge / Height = 0"});
  test::expectRefusal([] { layeredWedgeMesh({}, 0.1, 0); }, {"Wedge / Layers = 0"});
  test::expectRefusal([] { layeredWedgeMesh({}, -0.1, 3); }, {"Wedge / Depth = -0.1"});
}
