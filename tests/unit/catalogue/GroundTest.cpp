#include "catalogue/receivers/Ground.hpp"

#include "unit/io/BlockMesh.hpp"
#include "unit/io/Stage.hpp"

using namespace asperity;
using namespace asperity::catalogue;

namespace
{
// The base of the block as ground that looks down: y = -(0.1 x + 0.2 z), so that "up" is -y.
io::OutputDomain slope()
{
  auto const mesh = test::blockMesh(false, [](Point<3> const& x) {
    return Point<3>{x[0], x[1] - 0.1 * x[0] - 0.2 * x[2], x[2]};
  });
  return io::boundaryDomain("surface", mesh, "base", test::world());
}

void expectPoint(std::vector<double> const& found, std::vector<double> const& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t d = 0; d < found.size(); ++d) {
    EXPECT_NEAR(found[d], expected[d], 1e-14) << d;
  }
}
} // namespace

TEST(Ground, IsFoundAboveAndBelowPlaces)
{
  auto const surface = slope();
  const Ground ground(surface, {0, -2, 0});
  auto const found = ground({1.3, 0.4, 0.6, 1.3, -0.35, 0.6});
  ASSERT_TRUE(found[0] && found[1]);
  expectPoint(found[0]->coordinates, {1.3, -0.25, 0.6});
  expectPoint(found[1]->coordinates, {1.3, -0.25, 0.6});
  EXPECT_NEAR(found[0]->rise, 0.65, 1e-14);
  EXPECT_NEAR(found[1]->rise, -0.1, 1e-14);
  // The diagonal of the square from (0, 0) to (1, 1), with its slope.
  EXPECT_NEAR(found[0]->element_size, std::sqrt(2 + 0.3 * 0.3), 1e-14);
  EXPECT_EQ(ground.verticalAxis(), 1);
}

TEST(Ground, AtVerticesAndEdgesIsTheSameOnAnyNumberOfRanks)
{
  auto const surface = slope();
  const Ground ground(surface, {0, -1, 0});
  auto const found = ground({2, 0, 1, 2.5, 0, 1, 4, 0, 3});
  const std::vector<double> heights = {-0.4, -0.45, -1};
  for (std::size_t i = 0; i < heights.size(); ++i) {
    ASSERT_TRUE(found[i]) << i;
    EXPECT_NEAR(found[i]->coordinates[1], heights[i], 1e-14) << i;
  }
}

TEST(Ground, BesideItThereIsNone)
{
  auto const surface = slope();
  auto const found = Ground(surface, {0, -1, 0})({-0.1, 0, 1, 2, 0, 3.1, 2, 0, 2.9});
  EXPECT_FALSE(found[0]);
  EXPECT_FALSE(found[1]);
  EXPECT_TRUE(found[2]);
}

TEST(Ground, TheVerticalMayBeInclined)
{
  auto const mesh = test::blockMesh(false, [](Point<3> const& x) { return x; });
  auto const surface = io::boundaryDomain("surface", mesh, "base", test::world()); // y = 0
  const Ground ground(surface, {1, -1, 0});
  auto const found = ground({1, 0.5, 1});
  ASSERT_TRUE(found[0]);
  expectPoint(found[0]->coordinates, {1.5, 0, 1});
  EXPECT_NEAR(found[0]->rise, std::sqrt(0.5), 1e-14);
  EXPECT_FALSE(ground.verticalAxis());
}

TEST(Ground, OfTwoSurfacesTheHigherOneCounts)
{
  auto mesh = test::stripMesh(6);
  auto& both = mesh.boundaries["both"];
  for (auto const* name : {"base", "surface"}) {
    auto const& facets = mesh.boundaries.at(name);
    both.insert(both.end(), facets.begin(), facets.end());
  }
  auto const surface =
    io::boundaryDomain("surface", mesh, "both", test::world(), io::CurveStart::smaller_x);
  // The direction has no part in the plane, so that up is +y.
  const Ground ground(surface, {0, 0, 1});
  auto const found = ground({0.5, 0.25, 0.5, 3});
  for (auto const& point : found) {
    ASSERT_TRUE(point);
    expectPoint(point->coordinates, {0.5, 1});
  }
  EXPECT_NEAR(found[1]->rise, -2, 1e-14);
}
