#include "io/catalogue/receivers/PointLocation.hpp"
#include "unit/io/Support.hpp"

#include <cmath>
#include <numeric>

using namespace asperity;
using namespace asperity::io;
using detail::LocatedPoint;
using test::world;

namespace
{
constexpr int num_base = 6;

// Values of a function of the coordinates at the owned nodes, one component.
template <class Function>
std::vector<double> nodal(Location const& location, Function const& function)
{
  std::vector<double> values;
  for (std::size_t i = 0; i < location.numOwned(); ++i) {
    values.push_back(function(&location.coordinates[i * location.dimension]));
  }
  return values;
}

double linear(double const* x) { return 3 + 2 * x[0] - 5 * x[1]; }
} // namespace

TEST(PointLocation, FindsCellsAnywhereInTheBody)
{
  const Location volume = volumeLocation(test::stripMesh(num_base), world());
  const std::vector<double> points{0.5, 0.75, 0.999, 0.001, 0.011, 0.3, 0.2, 0.01};
  const auto located = detail::locate(volume, points);
  const auto values = detail::Sampling(volume, located)(nodal(volume, linear), 1);
  for (std::size_t i = 0; i < located.size(); ++i) {
    EXPECT_NEAR(located[i].distance, 0, 1e-14);
    const auto& weights = located[i].weights;
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-15);
    EXPECT_NEAR(values[i], linear(&points[2 * i]), 1e-13) << i;
  }
}

TEST(PointLocation, ANodeHasItsOwnValue)
{
  const Location volume = volumeLocation(test::stripMesh(num_base), world());
  const double x = test::stripPosition(3, num_base); // in six cells
  const auto rough = [](double const* at) { return std::exp(7 * at[0]) + at[1]; };
  const auto located = detail::locate(volume, {x, 1});
  EXPECT_EQ(detail::Sampling(volume, located)(nodal(volume, rough), 1)[0],
            rough(std::vector<double>{x, 1}.data()));
}

TEST(PointLocation, BetweenElementsTheLeastNodesDecideOnAnyNumberOfRanks)
{
  const Location fault = boundaryLocation("fault", test::stripMesh(num_base), "base", world());
  const auto located = detail::locate(fault, {test::stripPosition(2, num_base), 0});
  auto nodes = located[0].nodes;
  std::sort(nodes.begin(), nodes.end());
  EXPECT_EQ(nodes, (std::vector<GlobalOrdinal>{1, 2}));
}

TEST(PointLocation, PointsBesideAFaultAreProjected)
{
  const Location fault = boundaryLocation("fault", test::stripMesh(num_base), "base", world());
  const auto located = detail::locate(fault, {0.5, -0.125, 1.5, 0.5});
  EXPECT_NEAR(located[0].distance, 0.125, 1e-15);
  EXPECT_NEAR(located[0].coordinates[0], 0.5, 1e-15);
  EXPECT_NEAR(located[0].coordinates[1], 0, 1e-15);
  EXPECT_NEAR(located[0].element_size, 16.0 / 25 - 9.0 / 25, 1e-15);
  EXPECT_NEAR(located[1].distance, std::sqrt(0.5), 1e-15); // from the end (1, 0)
  const auto positions = detail::Sampling(fault, located)(fault.positions, 1);
  EXPECT_NEAR(positions[0], 0.5, 1e-15);
  EXPECT_NEAR(positions[1], 1, 1e-15);
}

TEST(PointLocation, ComponentsStayApart)
{
  const Location fault = boundaryLocation("fault", test::stripMesh(num_base), "base", world());
  const auto located = detail::locate(fault, {0.1, 0, 0.9, 0});
  std::vector<double> values;
  for (const double position : fault.positions) {
    values.push_back(position);
    values.push_back(1 - position);
  }
  const auto sampled = detail::Sampling(fault, located)(values, 2);
  const std::vector<double> expected{0.1, 0.9, 0.9, 0.1};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(sampled[i], expected[i], 1e-15);
  }
}

TEST(PointLocation, TetrahedraAndTheirFaces)
{
  Mesh<3> mesh; // held by rank 0; the others have nothing
  mesh.num_global_vertices = 4;
  mesh.boundaries["base"] = {};
  if (world()->getRank() == 0) {
    mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0.5, 0.25, 4}};
    mesh.global_ids = {0, 1, 2, 3};
    mesh.num_owned = 4;
    mesh.cells = {{0, 1, 2, 3}};
    mesh.boundaries["base"] = {{0, 2, 1}};
  }
  const auto function = [](double const* x) { return x[0] + 10 * x[1] - 100 * x[2]; };
  const Location volume = volumeLocation(mesh, world());
  const auto inside = detail::locate(volume, {0.5, 0.4, 1});
  EXPECT_NEAR(inside[0].distance, 0, 1e-14);
  EXPECT_NEAR(detail::Sampling(volume, inside)(nodal(volume, function), 1)[0], -95.5, 1e-12);
  const Location fault = boundaryLocation("fault", mesh, "base", world());
  const auto beside = detail::locate(fault, {0.5, 1, -0.25});
  EXPECT_NEAR(beside[0].distance, 0.25, 1e-15);
  EXPECT_NEAR(detail::Sampling(fault, beside)(nodal(fault, function), 1)[0], 10.5, 1e-13);
}

TEST(PointLocation, TheShortestElement)
{
  const Location fault = boundaryLocation("fault", test::stripMesh(num_base), "base", world());
  EXPECT_NEAR(detail::shortestElement(fault), 1.0 / 25, 1e-15);
  EXPECT_NEAR(detail::shortestElement(volumeLocation(test::stripMesh(num_base), world())),
              std::sqrt(1 + 1.0 / 625), 1e-15);
}
