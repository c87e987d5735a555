#include "MeshSamples.hpp"

#include "mesh/Regions.hpp"
#include "mesh/generation/RectangleMesh.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
using Conditions = std::vector<NamedCondition<2>>;

bool isLeft(Point<2> const& p) { return p[0] < 0.5; }
bool isLow(Point<2> const& p) { return p[1] < 0.25; }
bool isEverywhere(Point<2> const&) { return true; }
bool isNowhere(Point<2> const&) { return false; }

GlobalMesh<2> unitSquare() { return rectangleMesh({1.0, 1.0, 4, 4, {0.0, 0.0}}); }
} // namespace

TEST(Regions, LastTrueConditionWins)
{
  auto mesh = unitSquare();
  overrideRegions(mesh, Conditions{{"west", isLeft}, {"deep", isLow}});
  ASSERT_EQ(mesh.region_names, (std::vector<std::string>{"body", "west", "deep"}));
  EXPECT_DOUBLE_EQ(measureOf(mesh, 0), 0.375);
  EXPECT_DOUBLE_EQ(measureOf(mesh, 1), 0.375);
  EXPECT_DOUBLE_EQ(measureOf(mesh, 2), 0.25);
}

TEST(Regions, ExistingNamesAreTakenUpAndEmptyRegionsDropped)
{
  auto mesh = unitSquare();
  overrideRegions(mesh, Conditions{{"all", isEverywhere}});
  EXPECT_EQ(mesh.region_names, std::vector<std::string>{"all"});
  EXPECT_DOUBLE_EQ(measureOf(mesh, 0), 1.0);
  overrideRegions(mesh, Conditions{{"west", isLeft}});
  overrideRegions(mesh, Conditions{{"all", isLow}});
  EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"all", "west"}));
  EXPECT_DOUBLE_EQ(measureOf(mesh, 0), 0.625);
}

TEST(Regions, RefusesARegionWithoutCells)
{
  const Conditions none{{"west", isNowhere}}, overridden{{"west", isLeft}, {"all", isEverywhere}};
  auto mesh = unitSquare();
  test::expectRefusal([&] { overrideRegions(mesh, none); }, {"Mesh / Regions / west", "no cell"});
  mesh = unitSquare();
  test::expectRefusal([&] { overrideRegions(mesh, overridden, "Deck"); }, {"Deck / west"});
}

TEST(Regions, WorkInThreeDimensions)
{
  auto mesh = cube();
  overrideRegions<3>(mesh, {{"low", [](Point<3> const& p) { return p[2] < p[1]; }}});
  EXPECT_NEAR(measureOf(mesh, 1), 0.5, 1e-15);
}
