#include "MeshSamples.hpp"

#include "mesh/MeshQuality.hpp"
#include "mesh/generation/Bisection.hpp"
#include "mesh/generation/BoxMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"

#include <set>

using namespace asperity;
using namespace asperity::mesh;

namespace
{
// Tetrahedra around a vertex that is not the centre of a lopsided octahedron. The longest edges of
// neighbours do not match, and there are marked tetrahedra of several types.
GlobalMesh<3> fan()
{
  GlobalMesh<3> mesh;
  mesh.vertices = {{0.1, 0.05, -0.2}, {1.0, 0.1, 0.2},  {0.3, 1.3, -0.1}, {-0.9, 0.4, 0.3},
                   {-0.2, -1.1, 0.1}, {0.2, -0.3, 1.7}, {-0.1, 0.2, -0.8}};
  for (int i = 0; i < 4; ++i) {
    const int one = 1 + i, next = 1 + (i + 1) % 4;
    mesh.cells.push_back({0, one, next, 5});
    mesh.cells.push_back({next, one, 0, 6});
    mesh.boundaries["upper"].push_back({one, next, 5});
    mesh.boundaries["lower"].push_back({next, one, 6});
    mesh.cell_regions.insert(mesh.cell_regions.end(), {0, 1});
  }
  mesh.region_names = {"above", "below"};
  return mesh;
}

// Similar cells have equal ratios of their edges' lengths.
std::size_t numShapes(GlobalMesh<3> const& mesh)
{
  std::set<std::array<long, 6>> shapes;
  for (auto const& cell : mesh.cells) {
    const auto points = corners(mesh, cell);
    std::array<long, 6> shape{};
    for (int i = 0, k = 0; i < 4; ++i) {
      for (int j = 0; j < i; ++j) {
        shape[k++] = std::lround(1e6 * distance<3>(points[i], points[j]) / longestEdge(points));
      }
    }
    std::sort(shape.begin(), shape.end());
    shapes.insert(shape);
  }
  return shapes.size();
}

SizeFunction<3> towards(Point<3> const& spot, double smallest, double growth)
{
  return
    [=](Tetrahedron const& cell) { return smallest + growth * distance<3>(centroid(cell), spot); };
}
} // namespace

TEST(TetrahedronBisection, LeavesAMeshThatIsFineEnough)
{
  const auto mesh = bisect<3>(cube(), [](Tetrahedron const&) { return 1.8; });
  EXPECT_EQ(mesh.cells, cube().cells);
  EXPECT_EQ(mesh.vertices, cube().vertices);
}

// Halving a sixth of a cube three times halves its diameter; in between it is shorter by
// sqrt(2 / 3) and sqrt(1 / 3).
TEST(TetrahedronBisection, RefinesUniformly)
{
  const auto coarse = boxMesh({{2.0, 1.0, 1.0}, {2, 1, 1}, {}});
  for (int k = 0; k < 10; ++k) {
    const double wanted = std::sqrt(3.0 - k % 3) * std::pow(2.0, -(k / 3));
    const auto mesh = bisect<3>(coarse, [&](Tetrahedron const&) { return 1.001 * wanted; });
    EXPECT_EQ(mesh.cells.size(), std::size_t(12) << k);
    EXPECT_NEAR(cellSizes(mesh).smallest_diameter, wanted, 1e-14);
    EXPECT_NEAR(cellSizes(mesh).largest_diameter, wanted, 1e-14);
    EXPECT_EQ(numShapes(mesh), 1u);
    expectConforming(mesh);
  }
}

TEST(TetrahedronBisection, FollowsTheSizeFunctionAndStaysConforming)
{
  const auto allowed = towards({0.3, 0.1, 0.0}, 0.01, 0.4);
  const auto coarse = boxMesh({{1.0, 1.0, 1.0}, {2, 1, 2}, {}});
  const auto mesh = bisect<3>(coarse, allowed);
  expectConforming(mesh);
  for (auto const& cell : mesh.cells) {
    const auto points = corners(mesh, cell);
    EXPECT_LE(longestEdge(points), allowed(points));
  }
  EXPECT_NEAR(cellSizes(mesh).measure, 1.0, 1e-12);
  for (auto const& boundary : coarse.boundaries) {
    const auto one = integralOfNormal(coarse, boundary.first);
    const auto other = integralOfNormal(mesh, boundary.first);
    EXPECT_LT(distance<3>(one, other), 1e-13) << boundary.first;
  }
  EXPECT_LT(cellSizes(mesh).smallest_diameter, 0.01);
  EXPECT_LT(mesh.cells.size(), 100000u); // of 100 million without grading
}

TEST(TetrahedronBisection, KeepsTheShapesOfCubes)
{
  const auto coarse = boxMesh({{1.0, 1.0, 1.0}, {1, 1, 1}, {}});
  const auto mesh = bisect<3>(coarse, towards({0.3, 0.1, 0.0}, 1e-5, 1.5));
  EXPECT_LT(cellSizes(mesh).smallest_diameter, 2e-5);
  EXPECT_EQ(numShapes(mesh), 3u);
  EXPECT_NEAR(cellSizes(mesh).smallest_angle, std::atan(1.0), 1e-6);
}

TEST(TetrahedronBisection, EndsWhateverTheFirstCells)
{
  const auto coarse = fan();
  checkMesh(coarse, "test");
  const auto mesh = bisect<3>(coarse, towards({0.1, 0.05, -0.2}, 0.02, 0.3));
  expectConforming(mesh);
  for (int region : {0, 1}) {
    EXPECT_NEAR(measureOf(mesh, region), measureOf(coarse, region), 1e-12);
  }
  for (char const* name : {"upper", "lower"}) {
    EXPECT_LT(distance<3>(integralOfNormal(mesh, name), integralOfNormal(coarse, name)), 1e-12);
  }
  EXPECT_LT(cellSizes(mesh).smallest_diameter, 0.02);
}

// However fine: what is small has no smaller angles than what is larger.
TEST(TetrahedronBisection, BoundsTheShapes)
{
  const auto coarse = fan();
  std::vector<GlobalMesh<3>> meshes;
  for (double smallest : {1e-3, 1e-5}) {
    meshes.push_back(bisect<3>(coarse, towards({0.1, 0.05, -0.2}, smallest, 0.6)));
  }
  EXPECT_LT(cellSizes(meshes[1]).smallest_diameter, 1e-5);
  EXPECT_NEAR(cellSizes(meshes[1]).smallest_angle, cellSizes(meshes[0]).smallest_angle, 1e-5);
  EXPECT_GT(cellSizes(meshes[1]).smallest_angle, 0.2 * cellSizes(coarse).smallest_angle);
  EXPECT_EQ(numShapes(meshes[1]), numShapes(meshes[0]));
}

TEST(TetrahedronBisection, GivesTheSameMeshAgain)
{
  const auto size = towards({0.3, 0.1, 0.0}, 0.05, 0.3);
  const auto first = bisect<3>(fan(), size), second = bisect<3>(fan(), size);
  expectEqual(first, second);
}

// A fault at x = 0 of 4 km by 4 km in first cells of 3.2 km = 2^4 times 200 m: 200 m on the fault,
// and no edge longer than sqrt(3) times what is wanted anywhere.
TEST(TetrahedronBisection, GivesTheFaultItsCellSizeExactly)
{
  const CellSize<3> size = [](Point<3> const& x) {
    const double along = std::max(0.0, x[2] - 4e3), down = std::max(0.0, -x[1] - 4e3);
    return 200.0 + 0.3 * std::hypot(x[0], along, down);
  };
  const auto coarse = boxMesh({{12.8e3, 12.8e3, 12.8e3}, {4, 4, 4}, {0.0, -12.8e3, 0.0}});
  const auto mesh = bisect<3>(coarse, largestDiameter<3>(size));
  expectConforming(mesh);
  int num_on_fault = 0;
  for (auto const& facet : mesh.boundaries.at("left")) {
    const auto points = corners(mesh, facet);
    const auto centre = centroid(points);
    if (centre[1] > -4e3 && centre[2] < 4e3) {
      EXPECT_DOUBLE_EQ(facetMeasure(points), 0.5 * 200.0 * 200.0);
      EXPECT_DOUBLE_EQ(longestEdge(points), 200.0 * std::sqrt(2.0));
      ++num_on_fault;
    }
  }
  EXPECT_EQ(num_on_fault, 2 * 20 * 20);
  for (auto const& cell : mesh.cells) {
    const auto points = corners(mesh, cell);
    for (auto const& corner : points) {
      EXPECT_LE(longestEdge(points), 1.000001 * std::sqrt(3.0) * size(corner));
    }
  }
  EXPECT_LT(mesh.vertices.size(), 20000u); // of 262144 without grading
}

TEST(TetrahedronBisection, SeesSmallCellsWantedAnywhereInACell)
{
  const Tetrahedron cell = {{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 12}}};
  for (Point<3> const spot :
       {Point<3>{0, 0, 12}, {3, 3, 0}, {0, 3, 6}, {3, 0, 0}, centroid(cell)}) {
    const auto diameter = largestDiameter<3>(
      [&](Point<3> const& x) { return distance<3>(x, spot) < 1e-9 ? 0.5 : 3.0; });
    EXPECT_NEAR(diameter(cell), 0.5 * std::sqrt(3.0), 1e-8);
  }
  EXPECT_NEAR(largestDiameter<3>([](Point<3> const&) { return 3.0; })(cell), 3.0 * std::sqrt(3.0),
              1e-8);
}

// Cells next to one side of the period are refined with their neighbours beyond the other side.
TEST(TetrahedronBisection, GoesOnAcrossAPeriod)
{
  auto coarse = boxMesh({{1.0, 1.0, 3.0}, {1, 1, 3}, {}});
  makePeriodic(coarse, 2, "front", "back");
  const auto mesh = bisect<3>(coarse, towards({0.0, 0.0, 0.0}, 0.05, 0.5));
  expectConforming(mesh);
  EXPECT_EQ(mesh.period, coarse.period);
  EXPECT_NEAR(cellSizes(mesh).measure, 3.0, 1e-13);
  EXPECT_EQ(numShapes(mesh), 3u);
  double smallest_at_end = 3.0;
  for (auto const& cell : mesh.cells) {
    const auto points = corners(mesh, cell);
    for (auto const& corner : points) {
      EXPECT_LE(corner[2], 3.0);
      if (corner[2] > 2.99) {
        smallest_at_end = std::min(smallest_at_end, longestEdge(points));
      }
    }
  }
  EXPECT_LT(smallest_at_end, 0.1);
}

TEST(TetrahedronBisection, RefusesTooManyCellsBeforeItBegins)
{
  const auto coarse = boxMesh({{25.6e3, 25.6e3, 25.6e3}, {4, 4, 4}, {}});
  for (double slope : {0.0, 1e-3}) {
    int num_calls = 0;
    test::expectRefusal(
      [&] {
        bisect<3>(coarse, [&](Tetrahedron const& cell) {
          ++num_calls;
          return 10.0 + slope * centroid(cell)[1];
        });
      },
      {"Mesh", "vertices", "10000000"});
    EXPECT_LT(num_calls, 10000000);
  }
}
