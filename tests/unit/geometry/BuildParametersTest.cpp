#include "building/BuildParameters.hpp"

#include "base/Errors.hpp"

#include <Teuchos_Array.hpp>

#include <gtest/gtest.h>

#include <algorithm>

using namespace asperity::geometry;
using asperity::ParameterList;

namespace
{
Teuchos::Array<double> numbers(std::vector<double> const& values) { return values; }

// An upright rectangle below (1100, 2200) m of the projection, 4 km long from south to north.
ParameterList planeDeck()
{
  ParameterList list("Asperity");
  auto& fault = list.sublist("Faults").sublist("plane");
  fault.set("Top Centre", numbers({1100, 2200, -1000}));
  fault.set("Strike", 0.);
  fault.set("Dip", 90.);
  fault.set("Length", 4000.);
  fault.set("Width", 3000.);
  list.sublist("Box").set("Margin", 5000.);
  list.sublist("Box").set("Depth", 9000.);
  list.set("Cell Size", 500.);
  list.set("Largest", 2000.);
  return list;
}

TEST(BuildParameters, Defaults)
{
  auto list = planeDeck();
  const auto settings = readBuildSettings(list, "");
  EXPECT_EQ(settings.growth, 0.3);
  EXPECT_EQ(settings.largest, 2000);
  EXPECT_NEAR(settings.snap, 50, 1e-9); // 0.1 of the smallest size
  EXPECT_EQ(settings.stub_share, 0.05);
  EXPECT_EQ(settings.short_share, 0.1);
  EXPECT_FALSE(settings.is_y_up);
  EXPECT_FALSE(settings.tolerance);
  EXPECT_TRUE(settings.deck.empty());
  EXPECT_TRUE(settings.remarks.empty());
  ASSERT_EQ(settings.sizes.size(), 1u);
  EXPECT_EQ(settings.sizes[0]({0, 0, 0}, 0, 0), 500);
  auto const& box = settings.model.box;
  EXPECT_NEAR(box.low[0], 1100 - 5000, 1e-6);
  EXPECT_NEAR(box.high[1], 2200 + 2000 + 5000, 1e-6);
  EXPECT_EQ(box.low[2], -9000);
  EXPECT_EQ(box.high[2], 0);
}

TEST(BuildParameters, EveryEntryIsRead)
{
  auto list = planeDeck();
  list.set("Origin", numbers({1000, 2000}));
  list.set("Growth", 0.7);
  list.set("Snap", 12.);
  list.set("Trim Stubs", 0.2);
  list.set("Shortest Edge", 0.4);
  list.set("Vertical Axis", std::string("y"));
  list.set("Tolerance", 33.);
  list.set("Deck", std::string("run.xml"));
  list.sublist("Faults").sublist("plane").set("Cell Size", std::string("100 - 0.1 * z"));
  for (auto const& [entry, name] :
       {std::pair("West", "w"), std::pair("East", "e"), std::pair("South", "s"),
        std::pair("North", "n"), std::pair("Bottom", "b"), std::pair("Ground", "g")}) {
    list.sublist("Box").set(entry, std::string(name));
  }
  const auto settings = readBuildSettings(list, "folder");
  EXPECT_EQ(settings.growth, 0.7);
  EXPECT_EQ(settings.snap, 12);
  EXPECT_EQ(settings.stub_share, 0.2);
  EXPECT_EQ(settings.short_share, 0.4);
  EXPECT_TRUE(settings.is_y_up);
  EXPECT_EQ(settings.tolerance, 33);
  EXPECT_EQ(settings.deck, "folder/run.xml");
  EXPECT_NEAR(settings.sizes[0]({0, 0, -2000}, 0, 0), 300, 1e-9);
  auto const& model = settings.model;
  std::vector<std::string> names;
  for (auto const& surface : model.surfaces) {
    names.push_back(surface.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"plane", "g", "w", "e", "s", "n", "b"}));
  for (auto const& point : model.surfaces[0].surface.points) {
    EXPECT_NEAR(point[0], 100, 1e-6); // less the origin
    EXPECT_LE(std::abs(point[1] - 200), 2000 + 1e-6);
  }
}

TEST(BuildParameters, NamesThatAreTaken)
{
  auto list = planeDeck();
  list.sublist("Box").set("West", std::string("plane"));
  EXPECT_THROW(readBuildSettings(list, ""), asperity::InputError);
  auto other = planeDeck();
  other.sublist("Box").set("North", std::string("far"));
  other.sublist("Box").set("Ground", std::string("far"));
  EXPECT_THROW(readBuildSettings(other, ""), asperity::InputError);
}

TEST(BuildParameters, WallsMayShareAName)
{
  auto list = planeDeck();
  for (auto const* wall : {"West", "East", "South", "North", "Bottom"}) {
    list.sublist("Box").set(wall, std::string("far"));
  }
  auto const& surfaces = readBuildSettings(list, "").model.surfaces;
  EXPECT_EQ(std::count_if(surfaces.begin(), surfaces.end(),
                          [](auto const& surface) { return surface.name == "far"; }),
            5);
}
} // namespace
