#include "Plugins.hpp"
#include "SurfaceSamples.hpp"

#include "surfaces/files/SurfaceFormat.hpp"
#include "surfaces/grids/GridFormat.hpp"
#include "surfaces/kinds/SurfaceKind.hpp"
#include "surfaces/kinds/SurfaceKinds.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <string>

using namespace asperity;
using namespace asperity::geometry;

namespace
{
class SurfaceKinds : public FileTest
{
protected:
  void SetUp() override
  {
    FileTest::SetUp();
    context_.folder = folder();
    context_.remark = [](std::string const& remark) { ADD_FAILURE() << remark; };
  }

  // As a deck is read.
  TriangleSurface make(ParameterList list) const
  {
    const std::string path = "Asperity / Faults / main";
    Declare declare;
    declareSurface(declare).real("Cell Size", 1., "m", Range::positive(), "Cells have this size.");
    chooseSurfaceType(list, path);
    completeAndValidate(list, *declare.list(), path);
    return makeSurface(list, path, context_);
  }

  void expectRefused(ParameterList const& list, std::vector<std::string> const& parts) const
  {
    test::expectRefusal([&] { make(list); }, parts);
  }

  SurfaceContext context_;
};

ParameterList listOf(std::vector<std::pair<std::string, std::string>> const& texts)
{
  ParameterList list;
  for (auto const& [name, text] : texts) {
    list.set(name, text);
  }
  return list;
}

const std::string triangle = "OFF\n3 1 0\n0 0 0\n2 0 0\n0 2 -1\n";
} // namespace

TEST_F(SurfaceKinds, AreRegisteredWithTheirFormats)
{
  using Names = std::vector<std::string>;
  EXPECT_EQ(SurfaceKindRegistry::instance().names(),
            (Names{"Contours", "Grid", "Plane", "Surface File", "Trace"}));
  EXPECT_EQ(SurfaceFormatRegistry::instance().names(),
            (Names{"GOCAD TSurf", "OBJ", "OFF", "PLY", "STL"}));
  EXPECT_EQ(GridFormatRegistry::instance().names(),
            (Names{"ESRI ascii", "SRTM", "netCDF", "points"}));
}

// A plugin that registers none of these is refused, and so is a name that is taken.
TEST_F(SurfaceKinds, CountForPlugins)
{
  const auto all = registrations();
  for (std::string const name : {"mesh format 'Gmsh'", "surface format 'OFF'", "grid format 'SRTM'",
                                 "kind of surface 'Plane'"}) {
    EXPECT_EQ(std::count(all.begin(), all.end(), name), 1) << name;
  }
}

TEST_F(SurfaceKinds, EntryForAFile)
{
  EXPECT_EQ(fileEntryFor("a/main.STL", {"Units", "Dip"}), "Surface File");
  EXPECT_EQ(fileEntryFor("main.ts.gz", {}), "Surface File");
  EXPECT_EQ(fileEntryFor("dem.grd", {"Units"}), "Grid File");
  EXPECT_EQ(fileEntryFor("main.txt", {"Units", "Dip", "Depth"}), "Trace File");
  EXPECT_EQ(fileEntryFor("main.txt", {"Units", "Lower Depth"}), "Contours File");
  EXPECT_EQ(fileEntryFor("main.txt", {"Units", "Cell Size"}), "Contours File");
}

TEST_F(SurfaceKinds, File)
{
  write("a.off", triangle + "3 0 1 2\n");
  const auto list = listOf({{"Surface File", "a.off"}, {"Units", "km"}});
  EXPECT_NEAR(areaOf(make(list)), std::sqrt(5.) * 1e6, 1e-3);
  context_.origin = {500, 100};
  EXPECT_EQ(extentOf(make(list), 0)[0], -500);
  EXPECT_EQ(extentOf(make(list), 1)[1], 1900);
  auto other = list;
  other.set("Depth Units", "m");
  EXPECT_EQ(extentOf(make(other), 2)[0], -1);
  EXPECT_EQ(extentOf(make(other), 0)[1], 1500);
}

TEST_F(SurfaceKinds, UnitsAreNeverGuessed)
{
  write("a.off", triangle + "3 0 1 2\n");
  expectRefused(listOf({{"Surface File", "a.off"}}),
                {"Asperity / Faults / main / Units", "missing"});
  expectRefused(listOf({{"Surface File", "a.off"}, {"Units", "miles"}}),
                {"Units", "'miles'", "km"});
  const auto degrees = listOf({{"Surface File", "a.off"}, {"Units", "degrees"}});
  expectRefused(degrees, {"Depth Units is missing", "degrees"});
  auto with_depth = degrees;
  with_depth.set("Depth Units", "km");
  expectRefused(with_depth, {"no projection", "utm11"});
}

TEST_F(SurfaceKinds, Degrees)
{
  if (!Projection::isAvailable()) {
    GTEST_SKIP() << "this build has no PROJ";
  }
  const Projection projection("+proj=tmerc +lat_0=0 +lon_0=0 +datum=WGS84", "Projection");
  context_.projection = &projection;
  write("a.off", triangle + "3 0 1 2\n");
  const auto surface =
    make(listOf({{"Surface File", "a.off"}, {"Units", "degrees"}, {"Depth Units", "km"}}));
  // The equator is an ellipse's axis: 2 degrees of it, in this projection a little longer.
  EXPECT_NEAR(extentOf(surface, 0)[1], 222639, 50);
  EXPECT_NEAR(extentOf(surface, 1)[1], 221149, 50); // of the meridian
  EXPECT_EQ(extentOf(surface, 2)[0], -1000);
}

TEST_F(SurfaceKinds, Trace)
{
  ParameterList list = listOf({{"Units", "km"}});
  list.set("Trace", test::array<double>({0, 0, 0, 10}));
  list.set("Dip", 45.);
  list.set("Depth", 8000.);
  list.set("Extend Up", false);
  EXPECT_NEAR(areaOf(make(list)), 10e3 * 8e3 * std::sqrt(2.), 1e-3);
  list.set("Extend Up", true);
  context_.highest_ground = 2000; // and 5 % of the height beyond
  EXPECT_NEAR(extentOf(make(list), 2)[1], 2500, 1e-9);
  list.set("Upper Depth", 3000.);
  EXPECT_NEAR(extentOf(make(list), 2)[1], -3000, 1e-9);
  EXPECT_NEAR(extentOf(make(list), 0)[0], 3000, 1e-9);
}

TEST_F(SurfaceKinds, DipThatVariesAlongStrike)
{
  write("trace.txt", "# x y dip\n0 0 90\n0 10000 45\n");
  ParameterList list = listOf({{"Units", "m"}, {"Trace File", "trace.txt"}});
  list.set("Trace Columns", "x y dip");
  list.set("Depth", 4000.);
  list.set("Extend Up", false);
  const auto offPlane = [](auto const& p) { return p[0] + p[2] * p[1] / 10e3; };
  EXPECT_LT(largest(make(list), offPlane), 1e-6);
  list.set("Dip", "45 + 10");
  expectRefused(list, {"Dip and a column of dips"});
  list.set("Trace Columns", "x y");
  expectRefused(list, {"line 2", "3 columns", "'x y'"});
  write("trace.txt", "0 0\n0 10000\n");
  list.set("Dip", "90 - 45 * y / 10000");
  EXPECT_LT(largest(make(list), offPlane), 1e-6);
  list.remove("Dip");
  expectRefused(list, {"has no dip"});
  write("trace.txt", "0 0 70\n0 10000 190\n");
  list.set("Trace Columns", "x y dip");
  expectRefused(list, {"line 2", "dip 190"});
}

TEST_F(SurfaceKinds, Contours)
{
  write("slab.txt", "20\n60 0 20\n60 50 20\nEND\n10\n30 50 10\n30 0 10\nEND\n");
  ParameterList list = listOf({{"Contours File", "slab.txt"}, {"Units", "km"}});
  list.set("Lower Depth", 15e3);
  const auto surface = make(list);
  EXPECT_LT(largest(surface, [](auto const& p) { return p[0] + 3 * p[2]; }), 1e-7);
  EXPECT_EQ(extentOf(surface, 2)[0], -15e3);
  EXPECT_NEAR(extentOf(surface, 2)[1], 750, 1e-9);
}

TEST_F(SurfaceKinds, Plane)
{
  ParameterList list;
  list.set("Top Centre", test::array<double>({0, 0, -2000}));
  list.set("Strike", 0.);
  list.set("Dip", 30.);
  list.set("Length", 5000.);
  list.set("Width", 4000.);
  EXPECT_NEAR(areaOf(make(list)), 2e7, 1e-3);
  EXPECT_NEAR(extentOf(make(list), 2)[0], -4000, 1e-9);
  list.set("Extend Up", true);
  EXPECT_NEAR(extentOf(make(list), 2)[1], 200, 1e-9);
  list.set("Dip", 95.);
  expectRefused(list, {"Dip = 95", "[0, 90]"});
}

TEST_F(SurfaceKinds, GridAsFault)
{
  write("slab.xyz", "0 0 10\n0 10 10\n10 0 20\n10 10 20\n20 0 nan\n20 10 30\n");
  ParameterList list = listOf(
    {{"Grid File", "slab.xyz"}, {"Units", "km"}, {"Depth Units", "km"}, {"Values", "Depth"}});
  const auto surface = make(list);
  EXPECT_EQ(surface.triangles.size(), 3u);
  EXPECT_LT(largest(surface, [](auto const& p) { return p[0] + p[2] + 10e3; }), 1e-6);
  list.remove("Depth Units");
  expectRefused(list, {"Depth Units is missing", "does not tell it"});
}

TEST_F(SurfaceKinds, GridAsGround)
{
  write("dem.asc", "ncols 4\nnrows 3\nxllcenter 0\nyllcenter 0\ncellsize 100\n"
                   "200 210 220 230\n100 110 120 130\n0 10 20 30\n");
  ParameterList list = listOf({{"Grid File", "dem.asc"}, {"Units", "m"}, {"Depth Units", "m"}});
  list.set("Step", 60.);
  context_.area = MapArea{{10, 20}, {210, 190}};
  context_.origin = {0, 5};
  const auto surface = make(list);
  EXPECT_EQ(extentOf(surface, 0), (std::array<double, 2>{10, 210}));
  EXPECT_EQ(extentOf(surface, 1), (std::array<double, 2>{20, 190}));
  EXPECT_EQ(surface.points.size(), 5u * 4u);
  EXPECT_LT(largest(surface, [](auto const& p) { return p[2] - p[1] - 5 - 0.1 * p[0]; }), 1e-9);
  context_.area->high[0] = 400;
  expectRefused(list, {"dem.asc", "x = ", "from 0 to 300", "Clamp"});
  list.set("Outside", "Clamp");
  EXPECT_NEAR(extentOf(make(list), 2)[1], 225, 1e-9);
  list.set("Step", 1e-3);
  expectRefused(list, {"more than 1e7", "Step"});
}

TEST_F(SurfaceKinds, WhatIsNotClearIsRefused)
{
  expectRefused(listOf({{"Units", "m"}}),
                {"Asperity / Faults / main", "'Surface File'", "'Contours File'", "'Top Centre'"});
  expectRefused(listOf({{"Surface File", "a.off"}, {"Trace File", "b.txt"}}),
                {"several types: 'Surface File', 'Trace'"});
  expectRefused(listOf({{"Surface File", "a.off"}, {"Units", "m"}, {"Variable", "z"}}),
                {"Variable", "Type = Grid"});
  expectRefused(listOf({{"Type", "Slab"}}), {"'Slab'", "Contours"});
}
