#include "io/files/OutputDirectory.hpp"
#include "unit/io/BlockMesh.hpp"
#include "unit/platforms/Deck.hpp"

#include <algorithm>
#include <cmath>

// What SEAS and SCEC take besides the time series of stations.
using namespace asperity;
using namespace asperity::io;
using test::world;

namespace
{
// x = 0, 1/4, 1 with the weights 1/8, 1/2, 3/8
struct MovingFault : test::Stage
{
  MovingFault() : Stage(3)
  {
    add("fault", "slip_rate", 1, [this](double const* x, int) { return (1 + time) * (1 + x[0]); });
    add("fault", "slip", 2, [this](double const*, int c) { return (c == 0 ? 3 : -4) * time; });
    add("fault", "shear_modulus", 1, [](double const* x, int) { return 1e6 * (1 + x[0]); });
    add("fault", "prescribed", 1, [](double const* x, int) { return x[0] == 1 ? 1 : 0; });
  }
};

// The node i of 5 reaches 1 m/s at the time i, from 1e-4 m/s a second before; the last one never.
struct RupturingFault : test::Stage
{
  RupturingFault() : Stage(5)
  {
    add("fault", "slip_rate", 1, [this](double const* x, int) {
      const double node = std::round(4 * std::sqrt(*x));
      return node < 4 && node <= time ? 1 : 1e-4;
    });
  }
};

// The base dips along -x; strike is along z. The node (2, 2) of the base ruptures at 1 s.
struct DippingFault : test::Stage
{
  DippingFault() : Stage(test::blockMesh(false, dipping))
  {
    add("fault", "slip_rate", 1, [this](double const* x, int) {
      const bool is_here = std::lround(x[0] / 0.8) == 2 && std::lround(x[2]) == 2;
      return is_here && time >= 1 ? 1 : 1e-4;
    });
  }
  static Point<3> dipping(Point<3> const& x)
  {
    return {0.8 * x[0] - 0.6 * x[1], 0.6 * x[0] + 0.8 * x[1], x[2]};
  }
};

void run(test::Stage& stage, ParameterList const& deck, std::filesystem::path const& directory,
         double step_size)
{
  OutputSet outputs(deck, stage.context(directory));
  for (int step = 0; step < 4; ++step) {
    outputs.write(stage.at(step, step_size, step == 3));
  }
  outputs.closeSegment();
  outputs.finish();
}
} // namespace

TEST(GlobalSeries, PeakRateAndMomentRate)
{
  test::TemporaryDirectory directory;
  MovingFault fault;
  run(fault, test::deckWith("Global", "SEAS"), directory.path(), 2);
  test::onRankZero([&] {
    const auto lines = test::dataLines(directory / "seas/global.dat");
    ASSERT_EQ(lines.size(), 5u);
    EXPECT_EQ(lines[0], "t max_slip_rate moment_rate");
    EXPECT_EQ(lines[2], " 2.00000000000000E+00   5.740313E-01   2.718750E+06");
  });
}

TEST(GlobalSeries, IsNotForScec)
{
  test::TemporaryDirectory directory;
  MovingFault fault;
  run(fault, test::deckWith("Global", "SCEC"), directory.path(), 2);
  EXPECT_TRUE(std::filesystem::exists(directory / "global.csv"));
  EXPECT_FALSE(std::filesystem::exists(directory / "scec"));
}

TEST(RuptureTimes, OfTheNodesOfACurve)
{
  for (std::string const platform : {"SEAS", "SCEC"}) {
    test::TemporaryDirectory directory;
    RupturingFault fault;
    auto deck = test::deckWith("Rupture", platform);
    deck.sublist("Rupture").set("Threshold", 1e-2);
    run(fault, deck, directory.path(), 1);
    test::onRankZero([&] {
      const bool is_seas = platform == "SEAS";
      const auto file = directory / (is_seas ? "seas/rupture.dat" : "scec/cplot");
      test::expectParts(test::contents(file), {"along strike (m) from the fault's end of"});
      test::expectParts(test::contents(file), {"down dip (m), 0 at the upper end"});
      const auto lines = test::dataLines(file);
      ASSERT_EQ(lines.size(), 6u);
      EXPECT_EQ(lines[0], is_seas ? "x2 x3 t" : "j k t"); // the fault is level: along strike
      EXPECT_EQ(lines[2], "  6.250000E-02   0.000000E+00  5.00000000000000E-01");
      EXPECT_EQ(lines[5], "  1.000000E+00   0.000000E+00  1.00000000000000E+09");
    });
  }
}

TEST(RuptureTimes, OfTheNodesOfASurface)
{
  test::TemporaryDirectory directory;
  DippingFault fault;
  auto deck = test::deckWith("Rupture", "SEAS");
  deck.sublist("Rupture").set("Threshold", 1e-2);
  run(fault, deck, directory.path(), 1);
  test::onRankZero([&] {
    const auto lines = test::dataLines(directory / "seas/rupture.dat");
    ASSERT_EQ(lines.size(), std::size_t((test::block_nx + 1) * (test::block_nz + 1) + 1));
    EXPECT_EQ(lines[0], "x2 x3 t");
    // 2 m along strike and, from the upper end at x = 4, 2 m down dip.
    const auto is_node = [](std::string const& line) {
      return test::contains(line, "  2.000000E+00   2.000000E+00");
    };
    const auto found = std::find_if(lines.begin(), lines.end(), is_node);
    ASSERT_NE(found, lines.end());
    test::expectParts(*found, {" 5.00000000000000E-01"});
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(), is_node), 1);
  });
}

TEST(RuptureTimes, CountFromWhereTheProblemDoes)
{
  test::TemporaryDirectory directory;
  DippingFault fault;
  auto deck = test::deckWith("Rupture", "SCEC");
  deck.sublist("Rupture").set("Threshold", 1e-2);
  deck.sublist("SCEC").set("Depth of Upper End", 7500.0);
  run(fault, deck, directory.path(), 1);
  test::onRankZero([&] {
    const auto lines = test::dataLines(directory / "scec/cplot");
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                            [](std::string const& line) {
                              return test::contains(line, "  2.000000E+00   7.502000E+03");
                            }),
              1);
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                            [](std::string const& line) {
                              return test::contains(line, "  2.000000E+00   2.000000E+00");
                            }),
              0);
  });
}

namespace
{
// The lines of slip.dat with slip 2 - y on a fault after two seconds; the displacement has so many
// components.
std::vector<std::string> slipProfile(io::OutputDomain const& fault, int components)
{
  test::TemporaryDirectory directory;
  test::Stage stage(3);
  stage.domains["fault"] = fault;
  stage.add("fault", "slip_rate", 1, [](double const*, int) { return 0.01; });
  stage.add("fault", "slip", 1, [&](double const* x, int) { return stage.time - x[1]; });
  stage.add("volume", "displacement", components, [](double const*, int) { return 0; });
  auto deck = test::deckWith("Fault History", "SEAS");
  deck.sublist("Fault History").set("Fields", Teuchos::Array<std::string>(1, "slip"));
  OutputSet outputs(deck, stage.context(directory.path()));
  outputs.write(stage.at(1, 2));
  outputs.closeSegment();
  std::vector<std::string> lines;
  test::onRankZero([&] {
    const auto file = directory / "seas/slip.dat";
    test::expectParts(test::contents(file), {"along the fault from its upper end (m)"});
    lines = test::dataLines(file);
  });
  return lines;
}
} // namespace

TEST(SlipProfiles, RowsFromTheUpperEndDown)
{
  for (const int components : {1, 2}) {
    const auto fault = boundaryDomain("fault", test::uprightStrip(3), "base", world());
    const auto lines = slipProfile(fault, components);
    test::onRankZero([&] {
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
}

// Down dip along the tangent of a fault that dips to the right is slip of a normal fault.
TEST(SlipProfiles, ThrustsArePositive)
{
  const auto fault = boundaryDomain("fault", test::dippingStrip(3), "base", world());
  const auto lines = slipProfile(fault, 2);
  test::onRankZero([&] {
    EXPECT_EQ(lines.back(), " 2.00000000000000E+00  -2.000000E+00  -2.000000E+00  -2.250000E+00"
                            "  -3.000000E+00");
  });
}

TEST(OutputDirectory, OverwriteRemovesTheFilesOfPlatforms)
{
  namespace fs = std::filesystem;
  test::TemporaryDirectory directory;
  test::onRankZero([&] {
    fs::create_directory(directory / "seas");
    fs::create_directory(directory / "scec");
  });
  for (char const* name :
       {"seas/fltst_dp075", "seas/slip.dat", "scec/cplot", "receivers.h5", "events.csv",
        "events_splay.csv", "events_notes.txt", "seas/tandem.txt"}) {
    test::write(directory / name, "x");
  }
  prepareOutputDirectory(directory.path(), ExistingResult::overwrite, *world());
  test::onRankZero([&] {
    std::vector<std::string> left;
    for (auto const& entry : fs::recursive_directory_iterator(directory.path())) {
      left.push_back(fs::relative(entry.path(), directory.path()).string());
    }
    std::sort(left.begin(), left.end());
    EXPECT_EQ(left, (std::vector<std::string>{"events_notes.txt", "seas", "seas/tandem.txt"}));
  });
}
