#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/generation/Bisection.hpp"
#include "mesh/generation/RectangleMesh.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
GlobalMesh<2> closedSquare()
{
  auto mesh = square();
  mesh.boundaries["left"] = {{3, 0}};
  mesh.boundaries["right"] = {{1, 2}};
  return mesh;
}
} // namespace

TEST(Bisection, LeavesAMeshThatIsFineEnough)
{
  const auto mesh = bisect<2>(closedSquare(), [](Triangle const&) { return 1.5; });
  EXPECT_EQ(mesh.cells.size(), 2u);
  EXPECT_EQ(mesh.vertices.size(), 4u);
}

// Halving a right isosceles triangle twice halves its diameter: 2^k cells of diameter sqrt(2)
// 2^(-k/2).
TEST(Bisection, RefinesUniformly)
{
  for (int k = 0; k < 7; ++k) {
    const double wanted = std::sqrt(2.0) * std::pow(2.0, -0.5 * k);
    const auto mesh = bisect<2>(closedSquare(), [&](Triangle const&) { return 1.001 * wanted; });
    EXPECT_EQ(mesh.cells.size(), std::size_t(2) << k);
    EXPECT_NEAR(cellSizes(mesh).smallest_diameter, wanted, 1e-14);
    EXPECT_NEAR(cellSizes(mesh).largest_diameter, wanted, 1e-14);
    expectConforming(mesh);
  }
}

TEST(Bisection, FollowsTheSizeFunctionAndStaysConforming)
{
  const Point<2> spot = {0.3, 0.1};
  const auto allowed = [&](Triangle const& cell) {
    return 1e-3 + 0.3 * distance<2>(centroid(cell), spot);
  };
  const auto mesh = bisect<2>(closedSquare(), allowed);
  expectConforming(mesh);
  for (auto const& cell : mesh.cells) {
    const auto triangle = corners(mesh, cell);
    EXPECT_LE(longestEdge(triangle), allowed(triangle));
  }
  EXPECT_NEAR(measureOf(mesh, 0), 0.5, 1e-14);
  EXPECT_NEAR(measureOf(mesh, 1), 0.5, 1e-14);
  EXPECT_NEAR(cellSizes(mesh).smallest_angle, std::atan(1.0), 1e-12);
  EXPECT_LT(cellSizes(mesh).smallest_diameter, 1e-3);
  EXPECT_LT(mesh.cells.size(), 2000u); // of 4 million without grading
}

// The longest edges of these cells do not match across the edges they share, for which a recursive
// bisection could run in circles.
TEST(Bisection, EndsWhateverTheFirstCells)
{
  GlobalMesh<2> fan;
  fan.vertices = {{0.0, 0.0}, {1.0, 0.1}, {0.3, 1.3}, {-0.9, 0.4}, {-0.2, -1.1}};
  fan.cells = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  fan.cell_regions = {0, 0, 0, 0};
  fan.region_names = {"body"};
  fan.boundaries = {{"rim", {{1, 2}, {2, 3}, {3, 4}, {4, 1}}}};
  const auto mesh = bisect<2>(fan, [](Triangle const& cell) {
    return 0.01 + 0.2 * distance<2>(centroid(cell), {0.0, 0.0});
  });
  expectConforming(mesh);
  EXPECT_NEAR(measureOf(mesh, 0), measureOf(fan, 0), 1e-13);
  EXPECT_LT(cellSizes(mesh).smallest_diameter, 0.01);
  EXPECT_GT(cellSizes(mesh).smallest_angle, 0.2 * cellSizes(fan).smallest_angle);
}

TEST(Bisection, GivesTheSameMeshAgain)
{
  const auto size = [](Triangle const& cell) { return 0.01 + 0.1 * centroid(cell)[0]; };
  const auto first = bisect<2>(square(), size), second = bisect<2>(square(), size);
  expectEqual(first, second);
}

// A half space with a fault of 20 km at x = 0, in first cells of 12.8 km = 2^7 times 100 m: 100 m
// on the fault, and no edge longer than sqrt(2) times what is wanted anywhere.
TEST(Bisection, GivesTheFaultItsCellSizeExactly)
{
  const CellSize<2> size = [](Point<2> const& x) {
    return 100.0 + 0.05 * std::hypot(x[0], std::max(0.0, -x[1] - 20e3));
  };
  const auto coarse = rectangleMesh({102.4e3, 102.4e3, 8, 8, {0.0, -102.4e3}});
  const auto mesh = bisect<2>(coarse, largestDiameter<2>(size));
  expectConforming(mesh);
  int num_on_fault = 0;
  for (auto const& [upper, lower] : mesh.boundaries.at("left")) {
    const double top = mesh.vertices[upper][1], bottom = mesh.vertices[lower][1];
    EXPECT_EQ(mesh.vertices[upper][0], 0.0);
    if (bottom >= -20e3) {
      EXPECT_DOUBLE_EQ(top - bottom, 100.0);
      ++num_on_fault;
    }
  }
  EXPECT_EQ(num_on_fault, 200);
  for (auto const& cell : mesh.cells) {
    const auto triangle = corners(mesh, cell);
    for (auto const& corner : triangle) {
      EXPECT_LE(longestEdge(triangle), 1.000001 * std::sqrt(2.0) * size(corner));
    }
  }
  EXPECT_NEAR(cellSizes(mesh).smallest_angle, std::atan(1.0), 1e-12);
  EXPECT_LT(mesh.vertices.size(), 10000u); // of a million without grading
}

// The smallest of what is wanted at corners, midpoints and centroid counts.
TEST(Bisection, SeesSmallCellsWantedAnywhereInACell)
{
  const Triangle cell = {{{0.0, 0.0}, {6.0, 0.0}, {0.0, 6.0}}};
  for (Point<2> const spot : {Point<2>{0.0, 0.0}, {6.0, 0.0}, {3.0, 3.0}, {0.0, 3.0}, {2.0, 2.0}}) {
    const auto diameter = largestDiameter<2>(
      [&](Point<2> const& x) { return distance<2>(x, spot) < 1e-9 ? 0.5 : 3.0; });
    EXPECT_NEAR(diameter(cell), 0.5 * std::sqrt(2.0), 1e-8);
  }
  EXPECT_NEAR(largestDiameter<2>([](Point<2> const&) { return 3.0; })(cell), 3.0 * std::sqrt(2.0),
              1e-8);
}

// A bisection to 10 million vertices takes a minute.
TEST(Bisection, RefusesTooManyCellsBeforeItBegins)
{
  const auto coarse = rectangleMesh({25.6e3, 25.6e3, 16, 16, {0.0, 0.0}});
  for (double slope : {0.0, 1e-4}) {
    int num_calls = 0;
    const auto allowed = [&](Triangle const& cell) {
      ++num_calls;
      return 0.1 + slope * centroid(cell)[1];
    };
    test::expectRefusal([&] { bisect<2>(coarse, allowed); }, {"Mesh", "vertices", "10000000"});
    EXPECT_LT(num_calls, 1000000);
  }
}
