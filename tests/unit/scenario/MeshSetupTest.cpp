#include "scenario/setup/MeshSetup.hpp"

#include "SampleDeck.hpp"
#include "mesh/MeshQuality.hpp"
#include "unit/base/Refusal.hpp"

namespace asperity::scenario
{
using namespace test;
using asperity::test::array;
using asperity::test::expectParts;
using asperity::test::refusal;

namespace
{
// 4 x 4 km in cells of 2 km beside a fault at x = 0, then changed.
Mesh<2> halfSpace(std::function<void(ParameterList&)> const& change = [](auto&) {})
{
  ParameterList list("Mesh");
  list.set("Type", "Rectangle");
  list.sublist("Rectangle").set("Width", 4e3).set("Height", 4e3);
  list.sublist("Rectangle").set("Cells X", 2).set("Cells Y", 2);
  list.sublist("Rectangle").set("Lower Left", array<double>({0., -4e3}));
  change(list);
  completeAndValidate(list, *meshParameters(), "Asperity / Mesh");
  return makeMesh<2>(list, "", world());
}

Mesh<2> graded(char const* cell_size, double factor = 1)
{
  return halfSpace([&](ParameterList& list) {
    list.sublist("Rectangle").set("Cell Size", cell_size).set("Cell Size Factor", factor);
  });
}

std::size_t facetsOn(Mesh<2> const& mesh, std::string const& boundary)
{
  return mesh::boundaryFacets(mesh, boundary).size();
}
} // namespace

TEST(MeshSetup, leavesARectangleWithoutCellSizeAsItIs) { EXPECT_EQ(halfSpace().cells.size(), 8); }

TEST(MeshSetup, gradesARectangleByItsCellSize)
{
  const auto size = "125 + 0.21875 * x";
  const auto fine = graded(size), coarse = graded(size, 2);
  EXPECT_EQ(facetsOn(fine, "left"), 32);
  EXPECT_EQ(facetsOn(fine, "right"), 4);
  EXPECT_EQ(facetsOn(coarse, "left"), 16);
  EXPECT_EQ(facetsOn(coarse, "right"), 2);
}

TEST(MeshSetup, refusesCellSizesThatAreNone)
{
  expectParts(refusal([] { graded("100 + t"); }), {"Mesh / Rectangle / Cell Size depends on t"});
  expectParts(refusal([] { graded("x - 1000"); }),
              {"Mesh / Rectangle / Cell Size = 'x - 1000' is -1000 at ", "outside (0, inf)"});
}

TEST(MeshSetup, namesPiecesOfTheBoundary)
{
  const auto mesh = halfSpace([](ParameterList& list) {
    list.sublist("Boundaries").set("fault", "x < 1 && y > -2000").set("far", "x > 3999");
  });
  EXPECT_EQ(facetsOn(mesh, "fault"), 1);
  EXPECT_EQ(facetsOn(mesh, "left"), 1);
  EXPECT_EQ(facetsOn(mesh, "far"), 2);
  EXPECT_EQ(mesh.boundaries.count("right"), 0);
}

TEST(MeshSetup, refusesConditionsThatChangeInTime)
{
  for (char const* name : {"Boundaries", "Regions"}) {
    const auto call = [name] {
      halfSpace([name](ParameterList& list) { list.sublist(name).set("part", "t < 1"); });
    };
    expectParts(refusal(call), {"Asperity / Mesh / ", name, " / part depends on t"});
  }
}

TEST(MeshSetup, refusesPiecesWithoutFacets)
{
  const auto call = [] {
    halfSpace([](ParameterList& list) { list.sublist("Boundaries").set("fault", "x < 0"); });
  };
  expectParts(refusal(call), {"Asperity / Mesh / Boundaries / fault", "no facet"});
}
} // namespace asperity::scenario
