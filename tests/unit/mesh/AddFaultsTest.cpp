#include "FaultSamples.hpp"

#include "mesh/Boundaries.hpp"

using namespace asperity;
using namespace asperity::mesh;

namespace
{
bool isOnXAxis(Point<2> const& p) { return p[1] == 0.0; }
bool isRight(Point<2> const& p) { return isOnXAxis(p) && p[0] >= 2.0; }
bool isNowhere(Point<2> const& p) { return p[0] == 0.3; }
bool isEverywhere(Point<2> const&) { return true; }

std::size_t numFacets(GlobalMesh<2> const& mesh, std::string const& name)
{
  return mesh.boundaries.at(name).size();
}
} // namespace

// A facet of which only the centre, or only the ends, are on the fault is none of it.
TEST(AddFaults, TakesFacetsInside)
{
  const auto mesh = faultedRectangle({{"fault", isOnXAxis}});
  checkMesh(mesh, "test");
  EXPECT_EQ(mesh.boundaries.size(), 5u);
  EXPECT_EQ(numFacets(mesh, "fault"), 4u);
  const auto part =
    faultedRectangle({{"part", [](auto& p) { return isOnXAxis(p) && p[0] > 1.4; }}});
  EXPECT_EQ(numFacets(part, "part"), 2u);
  const auto gap =
    faultedRectangle({{"gap", [](auto& p) { return isOnXAxis(p) && std::abs(p[0] - 1.5) > 0.2; }}});
  EXPECT_EQ(numFacets(gap, "gap"), 3u);
}

TEST(AddFaults, LastTrueConditionWins)
{
  auto mesh = faultedRectangle({{"fault", isOnXAxis}, {"east", isRight}});
  EXPECT_EQ(numFacets(mesh, "fault"), 2u);
  EXPECT_EQ(numFacets(mesh, "east"), 2u);
  addFaults<2>(mesh, {{"east", isOnXAxis}}); // takes those of a fault that is there already
  EXPECT_EQ(numFacets(mesh, "east"), 4u);
  EXPECT_EQ(mesh.boundaries.count("fault"), 0u);
}

TEST(AddFaults, RefusesWhatIsNoFault)
{
  test::expectRefusal(
    [] {
      faultedRectangle({{"fault", isNowhere}});
    },
    {"Mesh / Faults / fault: the fault has no facet"});
  test::expectRefusal(
    [] {
      faultedRectangle({{"one", isRight}, {"all", isOnXAxis}});
    },
    {"Mesh / Faults / one: the fault has no facet", "later faults"});
  test::expectRefusal(
    [] {
      faultedRectangle({{"top", isOnXAxis}});
    },
    {"Mesh / Faults / top: a boundary on the surface"});
}

// Outer boundaries never take facets of faults, before or after the split.
TEST(AddFaults, KeepsFaultsFromOuterBoundaries)
{
  const auto mesh =
    faultedRectangle({{"fault", [](auto& p) { return isOnXAxis(p) && p[0] > 0.5 && p[0] < 3.5; }}});
  for (auto with_rim : {mesh, split(mesh)}) {
    const auto fault = with_rim.boundaries.at("fault");
    overrideBoundaries<2>(with_rim, {{"rim", isEverywhere}});
    EXPECT_EQ(numFacets(with_rim, "rim"), 16u);
    EXPECT_EQ(with_rim.boundaries.at("fault"), fault);
    EXPECT_EQ(with_rim.boundaries.size(), 2u);
    test::expectRefusal(
      [&] {
        overrideBoundaries<2>(with_rim, {{"fault", isEverywhere}});
      },
      {"Mesh / Boundaries / fault: a fault inside the body has this name"});
  }
}
