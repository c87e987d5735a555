#include "fem/BoundaryMeasure.hpp"

#include "base/parallel/Reductions.hpp"
#include "unit/fem/SampleMeshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity::fem
{
using namespace fem::test;

namespace
{
double sumOverRanks(std::vector<double> const& values)
{
  const double mine = std::accumulate(values.begin(), values.end(), 0.0);
  return asperity::sumOverRanks(mine, *worldCommunicator());
}

template <int Dim>
std::vector<double> weightsOf(std::vector<NodalMeasure<Dim>> const& nodes)
{
  std::vector<double> weights;
  weights.reserve(nodes.size());
  for (auto const& node : nodes) {
    weights.push_back(node.weight);
  }
  return weights;
}
} // namespace

TEST(BoundaryMeasure, WeighTheirHalvesOfTheNeighbouringFacets)
{
  auto whole = uniformRectangle(6, 2, 3, 1);
  whole.vertices[2][0] += 0.1; // facets of 0.5, 0.6, 0.4, 0.5, ... m from the left
  auto const mesh = mesh::distribute(whole, *worldCommunicator());
  auto const bottom = boundaryMeasure(mesh, "bottom", *worldCommunicator());
  const std::vector<double> expected = {0.25, 0.55, 0.5, 0.45, 0.5, 0.5, 0.25};
  for (auto const& each : bottom) {
    ASSERT_LT(mesh.global_ids[each.node], 7);
    EXPECT_NEAR(each.weight, expected[mesh.global_ids[each.node]], 1e-15);
  }
  EXPECT_TRUE(std::is_sorted(bottom.begin(), bottom.end(),
                             [](auto const& a, auto const& b) { return a.node < b.node; }));
  EXPECT_EQ(sumOverRanks(std::vector<double>(bottom.size(), 1.)), 7);
}

TEST(BoundaryMeasure, HaveOutwardNormals)
{
  const double angle = 0.4;
  auto whole = uniformRectangle(4, 3, 3, 1);
  rotate(whole, angle);
  auto const mesh = mesh::distribute(whole, *worldCommunicator());
  for (auto const& [name, turns] :
       {std::pair{"right", 0}, {"top", 1}, {"left", 2}, {"bottom", 3}}) {
    for (auto const& measure : boundaryMeasure(mesh, name, *worldCommunicator())) {
      auto const& normal = measure.normal;
      EXPECT_NEAR(normal[0], std::cos(angle + turns * M_PI / 2), 1e-14) << name;
      EXPECT_NEAR(normal[1], std::sin(angle + turns * M_PI / 2), 1e-14) << name;
    }
  }
}

TEST(BoundaryMeasure, AverageTheNormalsAtCornersByTheLengthOfTheFacets)
{
  auto whole = uniformRectangle(2, 1, 6, 4); // at the lower right, facets of 3 m and of 4 m
  auto& hull = whole.boundaries["hull"] = whole.boundaries["bottom"];
  hull.insert(hull.end(), whole.boundaries["right"].begin(), whole.boundaries["right"].end());
  auto const mesh = mesh::distribute(whole, *worldCommunicator());
  auto const nodes = boundaryMeasure(mesh, "hull", *worldCommunicator());
  for (auto const& each : nodes) {
    if (mesh.global_ids[each.node] == 2) {
      EXPECT_NEAR(each.normal[0], 0.8, 1e-15);
      EXPECT_NEAR(each.normal[1], -0.6, 1e-15);
      EXPECT_NEAR(each.weight, 3.5, 1e-15);
    }
  }
  EXPECT_NEAR(sumOverRanks(weightsOf(nodes)), 10, 1e-14);
}

TEST(BoundaryMeasure, OfACubeHaveItsAreaAndNormals)
{
  auto const mesh = mesh::distribute(uniformCube(3), *worldCommunicator());
  auto const top = boundaryMeasure(mesh, "top", *worldCommunicator());
  EXPECT_NEAR(sumOverRanks(weightsOf(top)), 1, 1e-14);
  for (auto const& each : top) {
    EXPECT_EQ(mesh.vertices[each.node][2], 1);
    EXPECT_NEAR(each.normal[2], 1, 1e-15);
  }
  EXPECT_NEAR(sumOverRanks(weightsOf(boundaryMeasure(mesh, "sides", *worldCommunicator()))), 4,
              1e-14);
}

TEST(BoundaryMeasure, RefuseABoundaryThatIsNotThere)
{
  auto whole = uniformRectangle(2, 2, 1, 1);
  whole.boundaries["void"] = {};
  auto const mesh = mesh::distribute(whole, *worldCommunicator());
  asperity::test::expectRefusal([&] { boundaryMeasure(mesh, "botom", *worldCommunicator()); },
                                {"'botom'", "Did you mean 'bottom'?"});
  asperity::test::expectRefusal([&] { boundaryMeasure(mesh, "subduction", *worldCommunicator()); },
                                {"'subduction'", "'bottom'", "'left'", "'right'", "'top'"});
  asperity::test::expectRefusal([&] { boundaryMeasure(mesh, "void", *worldCommunicator()); },
                                {"'void'", "no facets"});
}
} // namespace asperity::fem
