#include "MeshSamples.hpp"

#include "mesh/Boundaries.hpp"
#include "mesh/generation/RectangleMesh.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
using Conditions = std::vector<NamedCondition<2>>;

bool isOnTheLeft(Point<2> const& p) { return p[0] < 1e-6; }
bool isDeepOnTheLeft(Point<2> const& p) { return isOnTheLeft(p) && p[1] < 0.5; }
bool isEverywhere(Point<2> const&) { return true; }
bool isInside(Point<2> const& p) { return std::min({p[0], p[1], 1.0 - p[0], 1.0 - p[1]}) > 1e-6; }

GlobalMesh<2> unitSquare() { return rectangleMesh({1.0, 1.0, 4, 4, {0.0, 0.0}}); }
} // namespace

TEST(Boundaries, ArePiecesOfThoseThatWereThere)
{
  auto mesh = unitSquare();
  overrideBoundaries(mesh, Conditions{{"creeping", isDeepOnTheLeft}});
  expectConforming(mesh);
  EXPECT_EQ(mesh.boundaries.size(), 5u);
  EXPECT_EQ(mesh.boundaries.at("left").size(), 2u);
  EXPECT_EQ(mesh.boundaries.at("creeping").size(), 2u);
  EXPECT_NEAR(integralOfNormal(mesh, "left")[0], -0.5, 1e-15);
  EXPECT_NEAR(integralOfNormal(mesh, "creeping")[0], -0.5, 1e-15);
  for (auto const& facet : mesh.boundaries.at("creeping")) {
    EXPECT_LT(centroid(corners(mesh, facet))[1], 0.5);
  }
}

TEST(Boundaries, LastTrueConditionWinsAndEmptyOnesAreDropped)
{
  auto mesh = unitSquare();
  overrideBoundaries(mesh, Conditions{{"rim", isEverywhere}, {"top", isDeepOnTheLeft}});
  expectConforming(mesh);
  ASSERT_EQ(mesh.boundaries.size(), 2u);
  EXPECT_EQ(mesh.boundaries.at("rim").size(), 14u);
  EXPECT_EQ(mesh.boundaries.at("top").size(), 2u); // a name that was there, with other facets now
}

TEST(Boundaries, NameWhatHadNoName)
{
  auto mesh = square(); // left and right have none
  overrideBoundaries(mesh, Conditions{{"west", isOnTheLeft}});
  EXPECT_NEAR(integralOfNormal(mesh, "west")[0], -1.0, 1e-15);
  EXPECT_EQ(mesh.boundaries.size(), 3u);
}

TEST(Boundaries, RefuseAConditionThatNamesNoFacet)
{
  auto mesh = unitSquare();
  const Conditions none{{"crack", isInside}}, no_more{{"left", isInside}},
    overridden{{"west", isOnTheLeft}, {"rim", isEverywhere}};
  test::expectRefusal([&] { overrideBoundaries(mesh, none); },
                      {"Mesh / Boundaries / crack", "no facet"});
  test::expectRefusal([&] { overrideBoundaries(mesh, no_more); }, {"Mesh / Boundaries / left"});
  test::expectRefusal([&] { overrideBoundaries(mesh, overridden, "Deck"); },
                      {"Deck / west", "later boundaries"});
  EXPECT_EQ(mesh.boundaries, unitSquare().boundaries);
}

TEST(Boundaries, WorkInThreeDimensions)
{
  auto mesh = cube();
  overrideBoundaries<3>(mesh, {{"floor", [](Point<3> const& p) { return p[2] < 1e-6; }}});
  EXPECT_NEAR(integralOfNormal(mesh, "floor")[2], -1.0, 1e-15);
  EXPECT_EQ(mesh.boundaries.at("side").size(), 2u);
}
