#include "unit/io/LinearFault.hpp"
#include "unit/platforms/Deck.hpp"

#include <cmath>

using namespace asperity;
using namespace asperity::io;
using Fault = test::LinearFault;
using test::position;

namespace
{
constexpr double step_size = 0.4;

ParameterList deck(std::string const& platform)
{
  auto list = test::deckWith("Receivers", platform);
  auto& receivers = list.sublist("Receivers");
  receivers.sublist("On Fault").set("dp003", position({0.3, 0.}));
  receivers.sublist("On Fault").set("dp000", position({0., 0.}));
  receivers.sublist("Off Fault").set("inside", position({0.5, 0.75}));
  return list;
}

// Steps 0 to 4, a segment closed after step 2 and at the end.
void run(Fault& fault, OutputSet& outputs)
{
  for (int step = 0; step <= 4; ++step) {
    outputs.write(fault.at(step, step_size, step == 4));
    if (step == 2) {
      outputs.closeSegment();
    }
  }
  outputs.closeSegment();
}
} // namespace

TEST(Stations, FilesForSeas)
{
  test::TemporaryDirectory directory;
  Fault fault(1); // antiplane
  auto list = deck("SEAS");
  list.sublist("Receivers").set("Every n Steps", 2);
  OutputSet outputs(list, fault.context(directory.path()));
  run(fault, outputs);
  test::onRankZero([&] {
    EXPECT_EQ(
      test::contents(directory / "seas/fltst_dp003"),
      "# This is the file header:\n"
      "# problem=BP1-QD\n"
      "# author=A. Modeller\n"
      "# date=2024/05/31\n"
      "# code=Asperity\n"
      "# code_version=1.2\n"
      "# element_size=50 m\n"
      "# location=on fault, (0.3, 0) m, 0.3 m from the end of smaller x\n"
      "# minimum_time_step=4.000000E-01\n"
      "# maximum_time_step=4.000000E-01\n"
      "# num_time_steps=4           \n"
      "# Column #1 = Time (s)\n"
      "# Column #2 = Slip (m)\n"
      "# Column #3 = Slip rate (log10 m/s)\n"
      "# Column #4 = Shear stress (MPa)\n"
      "# Column #5 = State (log10 s)\n"
      "# The line below lists the names of the data fields:\n"
      "t slip slip_rate shear_stress state\n"
      " 0.00000000000000E+00   0.000000E+00  -5.228787E-01   3.000000E-01   8.000000E+00\n"
      " 8.00000000000000E-01   2.400000E-01  -5.228787E-01  -5.000000E-01   8.000000E+00\n"
      " 1.60000000000000E+00   4.800000E-01  -5.228787E-01  -1.300000E+00   8.000000E+00\n");
    EXPECT_EQ(test::dataLines(directory / "seas/fltst_dp000")[1],
              " 0.00000000000000E+00   0.000000E+00  -9.900000E+01   0.000000E+00   8.000000E+00");
    const auto body = test::dataLines(directory / "seas/blkst_inside");
    EXPECT_EQ(body[0], "t disp vel");
    EXPECT_EQ(body[2], " 8.00000000000000E-01   2.800000E+00   7.500000E-01");
  });
}

TEST(Stations, WaterInTheFaultAddsItsPressureAndFlowForSeas)
{
  test::TemporaryDirectory directory;
  Fault fault(1); // antiplane
  fault.add("fault", "pore_pressure", 1, [](double const* x, int) { return 1e6 + 1e7 * x[0]; });
  fault.add("fault", "darcy_velocity", 2, [](double const*, int c) { return c == 0 ? 9 : -2e-7; });
  OutputSet outputs(deck("SEAS"), fault.context(directory.path()));
  run(fault, outputs);
  test::onRankZero([&] {
    const auto lines = test::dataLines(directory / "seas/fltst_dp003");
    EXPECT_EQ(lines[0], "t slip slip_rate shear_stress pore_pressure darcy_vel state");
    EXPECT_EQ(lines[1], " 0.00000000000000E+00   0.000000E+00  -5.228787E-01   3.000000E-01"
                        "   4.000000E+00   2.000000E-07   8.000000E+00");
    test::expectParts(test::contents(directory / "seas/fltst_dp003"),
                      {"# Column #5 = Pore pressure (MPa)\n"
                       "# Column #6 = Darcy velocity down (m/s)\n"
                       "# Column #7 = State (log10 s)\n"});
  });
}

TEST(Stations, ThermalPressurisationAddsTemperatureAndPressureForScec)
{
  test::TemporaryDirectory directory;
  Fault fault;
  fault.add("fault", "temperature", 1, [](double const* x, int) { return 500 + 10 * x[0]; });
  fault.add("fault", "fluid_pressure", 1, [](double const*, int) { return 8e7; });
  fault.add("fault", "effective_normal_stress", 1, [](double const*, int) { return 4.5e7; });
  OutputSet outputs(deck("SCEC"), fault.context(directory.path()));
  run(fault, outputs);
  test::onRankZero([&] {
    const auto lines = test::dataLines(directory / "scec/faultdp003");
    EXPECT_EQ(lines[0], "t h-slip h-slip-rate h-shear-stress v-slip v-slip-rate v-shear-stress "
                        "n-stress log-theta temperature pressure");
    test::expectParts(lines[1], {"   4.500000E+01   8.000000E+00   5.030000E+02   8.000000E+01"});
    test::expectParts(test::contents(directory / "scec/faultdp003"),
                      {"# Column #8 = effective normal stress (MPa)\n",
                       "# Column #10 = temperature (K)\n# Column #11 = pore pressure (MPa)\n"});
  });
}

TEST(Stations, InPlaneStrainSeasTakesNormalStressAndTwoComponents)
{
  test::TemporaryDirectory directory;
  Fault fault;
  OutputSet outputs(deck("SEAS"), fault.context(directory.path()));
  run(fault, outputs);
  test::onRankZero([&] {
    const auto on_fault = test::dataLines(directory / "seas/fltst_dp000");
    EXPECT_EQ(on_fault[0], "t slip slip_rate shear_stress normal_stress state");
    test::expectParts(on_fault[1], {" 5.000000E+01   8.000000E+00"});
    const auto body = test::dataLines(directory / "seas/srfst_inside");
    EXPECT_EQ(body[0], "t disp_1 disp_2 vel_1 vel_2");
    EXPECT_EQ(body[1], " 0.00000000000000E+00   2.000000E+00   4.000000E+00   7.500000E-01"
                       "   1.500000E+00");
  });
}

// A fault that dips to the right, its hanging wall there. Its tangent points down dip: in a thrust
// slip along it is negative, and positive in the files.
TEST(Stations, InASectionSeasCountsThrustsAndDepthsPositive)
{
  test::TemporaryDirectory directory;
  Fault fault(2, test::dippingStrip(6));
  auto list = test::deckWith("Receivers", "SEAS");
  auto& receivers = list.sublist("Receivers");
  receivers.sublist("On Fault").set("dp003", position({0.3 * std::sqrt(2.0)}));
  receivers.sublist("Off Fault").set("inside", position({0.5, 0.25}));
  OutputSet outputs(list, fault.context(directory.path()));
  run(fault, outputs);
  test::onRankZero([&] {
    const auto on_fault = test::dataLines(directory / "seas/fltst_dp003"); // at 0, 0.8 and 1.6 s
    EXPECT_EQ(on_fault[5], " 1.60000000000000E+00  -4.800000E-01  -5.228787E-01   1.300000E+00"
                           "   5.030000E+01   8.000000E+00");
    const auto body = test::dataLines(directory / "seas/srfst_inside");
    EXPECT_EQ(body[1], " 0.00000000000000E+00   1.000000E+00  -2.000000E+00   2.500000E-01"
                       "  -5.000000E-01");
  });
}

// The same with the body below its fault: in a thrust the foot wall moves down dip.
TEST(Stations, InASectionThrustsOfAFootWallArePositiveToo)
{
  test::TemporaryDirectory directory;
  Fault fault(2, test::dippingStrip(6));
  fault.domains.at("fault").is_foot_wall = true;
  auto list = test::deckWith("Receivers", "SEAS");
  list.sublist("Receivers").sublist("On Fault").set("dp003", position({0.3 * std::sqrt(2.0)}));
  OutputSet outputs(list, fault.context(directory.path()));
  run(fault, outputs);
  test::onRankZero([&] {
    const auto on_fault = test::dataLines(directory / "seas/fltst_dp003");
    EXPECT_EQ(on_fault[5], " 1.60000000000000E+00   4.800000E-01  -5.228787E-01  -1.300000E+00"
                           "   5.030000E+01   8.000000E+00");
  });
}

TEST(Stations, FilesForScecHaveRowsAtEqualDistances)
{
  test::TemporaryDirectory directory;
  Fault fault;
  auto list = deck("SCEC");
  list.sublist("Receivers").set("Every n Steps", 0); // whatever receivers.h5 has
  OutputSet outputs(list, fault.context(directory.path()));
  run(fault, outputs);
  test::onRankZero([&] {
    const auto text = test::contents(directory / "scec/faultdp003");
    test::expectParts(text, {"# time_step=2.500000E-01\n# num_time_steps=7  "});
    const auto lines = test::dataLines(directory / "scec/faultdp003");
    ASSERT_EQ(lines.size(), 1u + 7); // 0 to 1.5 s of 1.6 s
    EXPECT_EQ(lines[0], "t h-slip h-slip-rate h-shear-stress v-slip v-slip-rate v-shear-stress "
                        "n-stress log-theta");
    EXPECT_EQ(lines[6], " 1.25000000000000E+00   3.750000E-01   3.000000E-01  -9.500000E-01"
                        "   0.000000E+00   0.000000E+00   0.000000E+00   5.030000E+01"
                        "   8.000000E+00");
    const auto body = test::dataLines(directory / "scec/bodyinside");
    EXPECT_EQ(body[0], "t h-disp h-vel v-disp v-vel n-disp n-vel");
    EXPECT_EQ(body[6], " 1.25000000000000E+00   3.250000E+00   7.500000E-01   0.000000E+00"
                       "   0.000000E+00   5.250000E+00   1.500000E+00");
  });
}

TEST(Stations, InASectionScecTakesSlipDownDip)
{
  test::TemporaryDirectory directory;
  Fault fault(2, test::uprightStrip(6));
  auto list = test::deckWith("Receivers", "SCEC");
  list.sublist("Receivers").sublist("On Fault").set("dp003", position({0., -0.3}));
  list.sublist("Receivers").sublist("Off Fault").set("inside", position({-0.75, -0.5}));
  OutputSet outputs(list, fault.context(directory.path()));
  run(fault, outputs);
  test::onRankZero([&] {
    // At t = 0 with x = 0 on the fault; in the body h is nothing, v is along y, n along x.
    EXPECT_EQ(test::dataLines(directory / "scec/faultdp003")[5],
              " 1.00000000000000E+00   0.000000E+00   0.000000E+00   0.000000E+00   0.000000E+00"
              "   0.000000E+00  -1.000000E+00   5.000000E+01   8.000000E+00");
    EXPECT_EQ(test::dataLines(directory / "scec/bodyinside")[1],
              " 0.00000000000000E+00   0.000000E+00   0.000000E+00  -3.500000E+00  -1.000000E+00"
              "  -1.750000E+00  -5.000000E-01");
  });
}

TEST(Stations, ARestartWithRowsAtOtherDistancesIsRefused)
{
  test::TemporaryDirectory directory;
  Fault fault;
  OutputSet before(deck("SCEC"), fault.context(directory.path()));
  run(fault, before);
  const Archive archive = before.save();
  auto list = deck("SCEC");
  list.sublist("SCEC").set("Time Step", 0.5);
  OutputSet after(list, fault.context(directory.path()));
  test::expectRefusal([&] { after.restore(archive); },
                      {"Asperity / Output: `SCEC / Time Step` is 0.5 s, but it was "
                       "0.25 s in the run"});
  OutputSet same(deck("SCEC"), fault.context(directory.path()));
  same.restore(archive);
}
