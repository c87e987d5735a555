#include "scenario/setup/mesh/MeshSetup.hpp"

#include "SampleDeck.hpp"
#include "mesh/MeshQuality.hpp"
#include "scenario/setup/mesh/GeneratedMesh.hpp"
#include "unit/base/Refusal.hpp"

#include <map>
#include <string>

namespace asperity::scenario
{
using namespace test;
using namespace asperity::test;

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
  return makeMesh<2>(MeshSettings::from(list), "", mesh::BranchEnd::tip, world());
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

TEST(MeshSetup, LeavesARectangleWithoutCellSizeAsItIs) { EXPECT_EQ(halfSpace().cells.size(), 8); }

TEST(MeshSetup, KnowsTheDimensionOfEachType)
{
  std::map<std::string, int> dimensions;
  for (auto const& type : generatedMeshes()) {
    ParameterList list("Mesh");
    list.set("Type", type.name);
    completeAndValidate(list, *meshParameters(), "Asperity / Mesh");
    dimensions[type.name] = meshDimension(list, *world());
  }
  EXPECT_EQ(dimensions, (std::map<std::string, int>{
                          {"Wedge", 2}, {"Rectangle", 2}, {"Deep Wedge", 3}, {"Box", 3}}));
}

TEST(MeshSetup, GradesARectangleByItsCellSize)
{
  const auto size = "125 + 0.21875 * x";
  const auto fine = graded(size), coarse = graded(size, 2);
  EXPECT_EQ(facetsOn(fine, "left"), 32);
  EXPECT_EQ(facetsOn(fine, "right"), 4);
  EXPECT_EQ(facetsOn(coarse, "left"), 16);
  EXPECT_EQ(facetsOn(coarse, "right"), 2);
}

TEST(MeshSetup, KeepsTheProportionsOfColumnsAndRows)
{
  const auto mesh = halfSpace([](ParameterList& list) {
    list.sublist("Rectangle").set("Cells X", 7).set("Cells Y", 4).set("Cell Size", "125 + x - x");
  });
  EXPECT_EQ(facetsOn(mesh, "left"), 32);
  EXPECT_EQ(facetsOn(mesh, "top"), 56);
  EXPECT_EQ(mesh.cells.size(), 2 * 32 * 56);
  EXPECT_EQ(mesh.vertices.size(), 33 * 57);
}

TEST(MeshSetup, RefusesCellSizesThatAreNone)
{
  expectRefusal([] { graded("100 + t"); }, {"Mesh / Rectangle / Cell Size depends on t"});
  expectRefusal([] { graded("x - 1000"); },
                {"Mesh / Rectangle / Cell Size = 'x - 1000' is -1000 at ", "outside (0, inf)"});
}

TEST(MeshSetup, RefusesMoreVerticesThanAllowedAndNamesWhatMayBeMissing)
{
  const auto limited = [](int most, char const* size, double width = 4e3) {
    return refusal([&] {
      halfSpace([&](ParameterList& list) {
        list.set("Most Vertices", most);
        list.sublist("Rectangle").set("Width", width).set("Cell Size", size);
      });
    });
  };
  // 1025 x 1025 vertices; the estimate is a lower one.
  expectParts(limited(100000, "3.90625 + 0 * x"),
              {"about ", "vertices are too many; at most 100000 ", "Asperity / Mesh / Rectangle",
               "Width, Height", "Asperity / Mesh / Most Vertices"});
  // Columns keep their proportion: a millimetre wide, they are as many as the rows.
  expectParts(limited(100000, "3.90625 + 0 * x", 1e-3), {"too many", "Width"});
  const auto graded = refusal([&] {
    halfSpace([](ParameterList& list) {
      list.set("Most Vertices", 10);
      list.sublist("Rectangle").set("Cells X", 40);
    });
  });
  expectParts(graded, {"Mesh: about 123 vertices are too many; at most 10"});
}

TEST(MeshSetup, NamesPiecesOfTheBoundary)
{
  const auto mesh = halfSpace([](ParameterList& list) {
    list.sublist("Boundaries").set("fault", "x < 1 && y > -2000").set("far", "x > 3999");
  });
  EXPECT_EQ(facetsOn(mesh, "fault"), 1);
  EXPECT_EQ(facetsOn(mesh, "left"), 1);
  EXPECT_EQ(facetsOn(mesh, "far"), 2);
  EXPECT_EQ(mesh.boundaries.count("right"), 0);
}

TEST(MeshSetup, SplitsAlongFaults)
{
  const auto mesh = halfSpace([](ParameterList& list) {
    list.sublist("Rectangle").set("Cells X", 4).set("Cells Y", 4);
    list.sublist("Faults").set("main", "abs(y + 2e3) < 1").set("splay", "x == 1e3 && y > -2001");
    list.sublist("Boundaries").set("all", "1");
  });
  EXPECT_EQ(mesh.faults, (std::vector<std::string>{"main", "splay"}));
  EXPECT_EQ(facetsOn(mesh, "main"), 4);
  EXPECT_EQ(facetsOn(mesh, "splay"), 2);
  EXPECT_EQ(facetsOn(mesh, "all"), 16);
  EXPECT_EQ(mesh.splits.size(), 8);
  EXPECT_EQ(mesh.vertices.size(), 25 + 8);
}

TEST(MeshSetup, RefinesWithBoundariesAndFaults)
{
  const auto refined = [](int refinements) {
    return halfSpace([=](ParameterList& list) {
      list.set("Refinements", refinements);
      list.sublist("Rectangle").set("Cells X", 4).set("Cells Y", 4);
      list.sublist("Faults").set("main", "abs(y + 2e3) < 1");
    });
  };
  const auto mesh = refined(2);
  EXPECT_EQ(mesh.cells.size(), 32 * 16);
  EXPECT_EQ(facetsOn(mesh, "main"), 16);
  EXPECT_EQ(facetsOn(mesh, "left"), 16);
  EXPECT_EQ(mesh.splits.size(), 17);
  EXPECT_EQ(mesh.vertices.size(), 17 * 17 + 17);
  expectRefusal([&] { refined(-1); }, {"Asperity / Mesh / Refinements = -1"});
  expectRefusal([&] { refined(25); }, {"Asperity / Mesh / Refinements = 25 makes some"});
}

TEST(MeshSetup, RefusesWhatIsNoFault)
{
  const auto with_fault = [](char const* name, char const* condition) {
    return refusal([=] {
      halfSpace([=](ParameterList& list) { list.sublist("Faults").set(name, condition); });
    });
  };
  expectParts(with_fault("main", "abs(x - 1e3) < 1"),
              {"Asperity / Mesh / Faults / main: the fault has no facet"});
  expectParts(with_fault("top", "abs(y + 2e3) < 1"),
              {"Asperity / Mesh / Faults / top: a boundary on the surface"});
  expectParts(with_fault("net", "1"), {"Asperity / Mesh: ", "facets of fault 'net' meet at"});
}

TEST(MeshSetup, RefusesConditionsThatChangeInTime)
{
  for (char const* name : {"Boundaries", "Faults", "Regions"}) {
    const auto call = [name] {
      halfSpace([name](ParameterList& list) { list.sublist(name).set("part", "t < 1"); });
    };
    expectRefusal(call, {"Asperity / Mesh / ", name, " / part depends on t"});
  }
}

TEST(MeshSetup, RefusesPiecesWithoutFacets)
{
  const auto call = [] {
    halfSpace([](ParameterList& list) { list.sublist("Boundaries").set("fault", "x < 0"); });
  };
  expectRefusal(call, {"Asperity / Mesh / Boundaries / fault", "no facet"});
}
} // namespace asperity::scenario
