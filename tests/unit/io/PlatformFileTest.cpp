#include "io/platforms/PlatformFile.hpp"
#include "io/catalogue/fault_geometry/FaultAxis.hpp"
#include "io/platforms/PlatformColumns.hpp"
#include "io/platforms/SlipProfiles.hpp"
#include "unit/io/Stage.hpp"

#include <limits>

using namespace asperity;
using namespace asperity::io;
using test::world;

namespace
{
// The strip, turned so that its base, the fault, is the line from (0, -1) up to (0, 0).
Location uprightFault(int num_base)
{
  auto mesh = test::stripMesh(num_base);
  for (auto& vertex : mesh.vertices) {
    vertex = {-vertex[1], vertex[0] - 1};
  }
  return boundaryLocation("fault", mesh, "base", world());
}

TextFormat formatOf(ParameterList const& list) { return TextFormat::from(list); }
} // namespace

TEST(PlatformFile, WhatHasNoLogarithmHasTheSmallest)
{
  EXPECT_EQ(detail::platformLogarithm(100), 2);
  EXPECT_EQ(detail::platformLogarithm(0), -99);
  EXPECT_EQ(detail::platformLogarithm(1e-300), -99);
  EXPECT_EQ(detail::platformLogarithm(-1), -99);
}

TEST(PlatformFile, TheHeaderKeepsItsLength)
{
  const auto format = test::textFormat(Platform::seas);
  detail::StepFacts facts;
  const auto before = detail::platformHeader(format, {"a", "", {}, "t"}, &facts);
  facts.add({0, 0, 0, 0, false}); // the initial state
  EXPECT_EQ(facts.count, 0);
  facts.add({1, 1, 1e-9, 0, false});
  facts.add({2, 2, 3e7, 0, false});
  facts.count = 123456789012;
  const auto after = detail::platformHeader(format, {"a", "", {}, "t"}, &facts);
  EXPECT_EQ(before.size(), after.size());
  EXPECT_TRUE(test::contains(after, "# minimum_time_step=1.000000E-09\n"
                                    "# maximum_time_step=3.000000E+07\n"
                                    "# num_time_steps=123456789012\n"));
}

TEST(PlatformFile, TheFactsComeFromTheDeck)
{
  EXPECT_EQ(formatOf({}).platform, Platform::none);
  ParameterList list;
  list.set("Text Format", "SCEC");
  list.sublist("SCEC").set("Problem", "TPV101").set("Time Step", 0.005);
  const auto scec = formatOf(list);
  EXPECT_EQ(scec.platform, Platform::scec);
  EXPECT_EQ(scec.folder(), "scec");
  EXPECT_EQ(scec.problem, "TPV101");
  EXPECT_EQ(scec.time_step, 0.005);
  EXPECT_EQ(scec.date.size(), 10u); // of today
  list.set("Text Format", "SEES");
  const auto message = test::inputError([&] { formatOf(list); });
  EXPECT_TRUE(test::contains(message, "Asperity / Output / Text Format")) << message;
}

TEST(PlatformFile, DistancesAreDownDip)
{
  const auto upright = detail::faultAxis(uprightFault(4));
  const auto level =
    detail::faultAxis(boundaryLocation("fault", test::stripMesh(4), "base", world()));
  EXPECT_FALSE(upright.is_level);
  EXPECT_TRUE(level.is_level);
  if (world()->getRank() == 0) {
    ASSERT_EQ(upright.distances.size(), 4u); // the nodes are numbered from below
    EXPECT_NEAR(upright.distances[0], 1, 1e-15);
    EXPECT_NEAR(upright.distances[1], 8.0 / 9, 1e-15);
    EXPECT_NEAR(upright.distances[3], 0, 1e-15);
    EXPECT_NEAR(level.distances[1], 1.0 / 9, 1e-15);
  }
}

TEST(PlatformFile, ColumnsOfASectionAreVertical)
{
  const detail::PlatformView section{false, false};
  const std::map<std::string, std::vector<double>> sampled{
    {"slip", {1, 2}},          {"slip_rate", {3, 4}},
    {"traction", {5e6, 6e6}},  {"normal_stress", {7e6, 8e6}},
    {"theta", {100, 1000}},    {"displacement", {1, 2, 3, 4}},
    {"velocity", {5, 6, 7, 8}}};
  const auto on_fault = detail::faultColumns(Platform::scec, section);
  EXPECT_EQ(detail::rowOf(on_fault, sampled, 1, 2), (std::vector<double>{0, 0, 0, 2, 4, 6, 8, 3}));
  EXPECT_EQ(detail::rowOf(detail::bodyColumns(Platform::scec, section), sampled, 1, 2),
            (std::vector<double>{0, 0, 4, 8, 3, 7}));
  EXPECT_EQ(detail::fieldsOf(on_fault),
            (std::vector<std::string>{"slip", "slip_rate", "traction", "normal_stress", "theta"}));
}

TEST(SlipProfiles, RowsFromTheUpperEndDown)
{
  test::TemporaryDirectory directory;
  test::Stage stage(3);
  stage.locations["fault"] = uprightFault(3);
  stage.add("fault", "slip_rate", 1, [](double const*, int) { return 0.01; });
  stage.add("fault", "slip", 1, [&](double const* x, int) { return stage.time - x[1]; });
  detail::SlipProfiles profiles(stage.context(directory.path(), test::textFormat(Platform::seas)));
  profiles.write(stage.at(1, 2));
  profiles.flush({});
  test::onRankZero([&] {
    const auto lines = test::dataLines(directory / "seas/slip.dat");
    const std::vector<std::string> expected{
      "z",
      "t",
      "max_slip_rate",
      "slip",
      " 0.00000000000000E+00   0.000000E+00   0.000000E+00   7.500000E-01   1.000000E+00",
      " 2.00000000000000E+00  -2.000000E+00   2.000000E+00   2.750000E+00   3.000000E+00"};
    EXPECT_EQ(lines, expected);
  });
}
