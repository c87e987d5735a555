#include "catalogue/receivers/PointLocation.hpp"

#include "base/parallel/Reductions.hpp"
#include "mesh/NearestPoint.hpp"
#include "mesh/generation/RectangleMesh.hpp"
#include "mesh/parallel/Partition.hpp"
#include "unit/io/BlockMesh.hpp"
#include "unit/io/Support.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace asperity;
using namespace asperity::catalogue;
using namespace asperity::io;
using test::world;

namespace
{
constexpr int num_base = 6;

// Values of a function of the coordinates at the owned nodes, one component.
template <class Function>
std::vector<double> nodal(OutputDomain const& domain, Function const& function)
{
  std::vector<double> values;
  for (std::size_t i = 0; i < domain.numOwned(); ++i) {
    values.push_back(function(&domain.coordinates[i * domain.dimension]));
  }
  return values;
}

double linear(double const* x) { return 3 + 2 * x[0] - 5 * x[1]; }
} // namespace

TEST(PointLocation, FindsCellsAnywhereInTheBody)
{
  const OutputDomain volume = volumeDomain(test::stripMesh(num_base), world());
  const std::vector<double> points{0.5, 0.75, 0.999, 0.001, 0.011, 0.3, 0.2, 0.01};
  const auto located = locate(volume, points);
  const auto values = Sampling(volume, located)(nodal(volume, linear), 1);
  for (std::size_t i = 0; i < located.size(); ++i) {
    EXPECT_NEAR(located[i].distance, 0, 1e-14);
    const auto& weights = located[i].weights;
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-15);
    EXPECT_NEAR(values[i], linear(&points[2 * i]), 1e-13) << i;
  }
}

TEST(PointLocation, ANodeHasItsOwnValue)
{
  const OutputDomain volume = volumeDomain(test::stripMesh(num_base), world());
  const double x = test::stripPosition(3, num_base); // in six cells
  const auto rough = [](double const* at) { return std::exp(7 * at[0]) + at[1]; };
  const auto located = locate(volume, {x, 1});
  EXPECT_EQ(Sampling(volume, located)(nodal(volume, rough), 1)[0],
            rough(std::vector<double>{x, 1}.data()));
}

TEST(PointLocation, BetweenElementsTheLeastNodesDecideOnAnyNumberOfRanks)
{
  const OutputDomain fault = boundaryDomain("fault", test::stripMesh(num_base), "base", world());
  const auto located = locate(fault, {test::stripPosition(2, num_base), 0});
  auto nodes = located[0].nodes;
  std::sort(nodes.begin(), nodes.end());
  EXPECT_EQ(nodes, (std::vector<GlobalOrdinal>{1, 2}));
}

TEST(PointLocation, PointsBesideAFaultAreProjected)
{
  const OutputDomain fault = boundaryDomain("fault", test::stripMesh(num_base), "base", world());
  const auto located = locate(fault, {0.5, -0.125, 1.5, 0.5});
  EXPECT_NEAR(located[0].distance, 0.125, 1e-15);
  EXPECT_NEAR(located[0].coordinates[0], 0.5, 1e-15);
  EXPECT_NEAR(located[0].coordinates[1], 0, 1e-15);
  EXPECT_NEAR(located[0].element_size, 16.0 / 25 - 9.0 / 25, 1e-15);
  EXPECT_NEAR(located[1].distance, std::sqrt(0.5), 1e-15); // from the end (1, 0)
  const auto positions = Sampling(fault, located)(fault.positions, 1);
  EXPECT_NEAR(positions[0], 0.5, 1e-15);
  EXPECT_NEAR(positions[1], 1, 1e-15);
}

TEST(PointLocation, ComponentsStayApart)
{
  const OutputDomain fault = boundaryDomain("fault", test::stripMesh(num_base), "base", world());
  const auto located = locate(fault, {0.1, 0, 0.9, 0});
  std::vector<double> values;
  for (const double position : fault.positions) {
    values.push_back(position);
    values.push_back(1 - position);
  }
  const auto sampled = Sampling(fault, located)(values, 2);
  const std::vector<double> expected{0.1, 0.9, 0.9, 0.1};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(sampled[i], expected[i], 1e-15);
  }
}

TEST(PointLocation, TetrahedraAndTheirFaces)
{
  const auto mesh = test::tetrahedron();
  const auto function = [](double const* x) { return x[0] + 10 * x[1] - 100 * x[2]; };
  const OutputDomain volume = volumeDomain(mesh, world());
  const auto inside = locate(volume, {0.5, 0.4, 1});
  EXPECT_NEAR(inside[0].distance, 0, 1e-14);
  EXPECT_NEAR(Sampling(volume, inside)(nodal(volume, function), 1)[0], -95.5, 1e-12);
  const OutputDomain fault = boundaryDomain("fault", mesh, "base", world());
  EXPECT_NEAR(shortestElement(fault), std::sqrt(2 * 3.), 1e-14); // of area 3
  const auto beside = locate(fault, {0.5, 1, -0.25});
  EXPECT_NEAR(beside[0].distance, 0.25, 1e-15);
  EXPECT_NEAR(Sampling(fault, beside)(nodal(fault, function), 1)[0], 10.5, 1e-13);
}

TEST(PointLocation, TheNearestOfAllElements)
{
  auto whole = mesh::rectangleMesh({1, 1, 23, 17, {0, 0}});
  for (auto& x : whole.vertices) {
    x = {x[0] * x[0], x[1] + 0.2 * x[0] * x[1]}; // cells of many sizes
  }
  const OutputDomain volume = volumeDomain(mesh::distribute(whole, *world()), world());
  std::vector<double> points;
  for (int i = 0; i < 400; ++i) {
    points.push_back(2 * std::fmod(0.618034 * i, 1) - 0.5);
    points.push_back(2 * std::fmod(0.754878 * i, 1) - 0.5);
  }
  const auto located = locate(volume, points);
  ASSERT_EQ(located.size(), 400U);
  for (std::size_t i = 0; i < located.size(); ++i) {
    double nearest = 1e30;
    for (std::size_t element = 0; element < volume.numOwnedElements(); ++element) {
      mesh::Simplex simplex{{}, 2};
      for (int corner = 0; corner < 3; ++corner) {
        simplex.corners.push_back(&volume.corners[(3 * element + corner) * 2]);
      }
      nearest = std::min(nearest, mesh::nearestPoint(simplex, &points[2 * i]).distance);
    }
    EXPECT_EQ(located[i].distance, minOverRanks(nearest, *world())) << i;
  }
}

TEST(PointLocation, AnotherPointSaysWhichSideOfAFaultIsMeant)
{
  Mesh<2> mesh; // two triangles above each other, whose vertices on y = 0 are pairs
  mesh.num_global_vertices = 6;
  if (world()->getRank() == 0) {
    mesh.vertices = {{0, 0}, {2, 0}, {0, 2}, {0, 0}, {2, 0}, {0, -2}};
    mesh.global_ids = {0, 1, 2, 3, 4, 5};
    mesh.num_owned = 6;
    mesh.cells = {{0, 1, 2}, {3, 5, 4}};
  }
  const OutputDomain volume = volumeDomain(mesh, world());
  const auto located = PointLocation(volume)({0.5, 0, 0.5, 0}, {0.5, 0.01, 0.5, -0.01});
  std::vector<double> sides;
  for (const GlobalOrdinal id : volume.vertex_ids) {
    sides.push_back(id < 3 ? 1 : -1);
  }
  const auto values = Sampling(volume, located)(sides, 1);
  EXPECT_NEAR(values[0], 1, 1e-14);
  EXPECT_NEAR(values[1], -1, 1e-14);
  for (auto const& point : located) {
    EXPECT_NEAR(point.distance, 0, 1e-14); // of the point itself
    EXPECT_NEAR(point.coordinates[0], 0.5, 1e-14);
  }
}

TEST(PointLocation, TheShortestElement)
{
  const OutputDomain fault = boundaryDomain("fault", test::stripMesh(num_base), "base", world());
  EXPECT_NEAR(shortestElement(fault), 1.0 / 25, 1e-15);
  EXPECT_NEAR(shortestElement(volumeDomain(test::stripMesh(num_base), world())),
              std::sqrt(1 + 1.0 / 625), 1e-15);
}
