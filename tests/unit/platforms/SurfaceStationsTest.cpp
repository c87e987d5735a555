#include "unit/io/VerticalFault.hpp"
#include "unit/platforms/Deck.hpp"

using namespace asperity;
using namespace asperity::io;
using test::position;

namespace
{
void run(std::filesystem::path const& directory, std::string const& platform,
         bool has_water = false)
{
  test::VerticalFault fault;
  if (has_water) {
    fault.add("fault", "pore_pressure", 1, [](double const*, int) { return 3e6; });
    fault.add("fault", "darcy_velocity", 3, [](double const*, int c) { return 1e-7 * (c + 1); });
  }
  auto list = test::deckWith("Receivers", platform);
  auto& receivers = list.sublist("Receivers");
  receivers.sublist("On Fault").set("st12dp07", position({0., -0.7, 1.2}));
  receivers.sublist("Off Fault").set("inside", position({0.3, -2.1, 0.4}));
  OutputSet outputs(list, fault.context(directory));
  outputs.write(fault.at(0, 1));
  outputs.write(fault.at(1, 1, true));
  outputs.closeSegment();
}
} // namespace

TEST(SurfaceStations, FilesForSeas)
{
  test::TemporaryDirectory directory;
  run(directory.path(), "SEAS");
  test::onRankZero([&] {
    const auto on_fault = test::dataLines(directory / "seas/fltst_st12dp07");
    EXPECT_EQ(on_fault[0], "t slip_2 slip_3 slip_rate_2 slip_rate_3 shear_stress_2 shear_stress_3 "
                           "state");
    // Strike is z: slip 3.8, rate 0.6, traction 3.2; down is -y: slip -1.9, rate -0.3, -2.2.
    EXPECT_EQ(on_fault[1], " 0.00000000000000E+00   3.800000E+00  -1.900000E+00  -2.218487E-01"
                           "  -5.228787E-01   3.200000E+00  -2.200000E+00   8.000000E+00");
    const auto body = test::dataLines(directory / "seas/blkst_inside");
    EXPECT_EQ(body[0], "t disp_1 disp_2 disp_3 vel_1 vel_2 vel_3");
    EXPECT_EQ(body[1], " 0.00000000000000E+00   3.000000E-01   4.000000E-01   2.100000E+00"
                       "   1.000000E+00   3.000000E+00  -2.000000E+00");
  });
}

TEST(SurfaceStations, WaterFlowsAlongStrikeAndDownDip)
{
  test::TemporaryDirectory directory;
  constexpr bool has_water = true;
  run(directory.path(), "SEAS", has_water);
  test::onRankZero([&] {
    const auto on_fault = test::dataLines(directory / "seas/fltst_st12dp07");
    EXPECT_EQ(on_fault[0], "t slip_2 slip_3 slip_rate_2 slip_rate_3 shear_stress_2 shear_stress_3 "
                           "pore_pressure darcy_vel_2 darcy_vel_3 state");
    test::expectParts(on_fault[1],
                      {"  -2.200000E+00   3.000000E+00   3.000000E-07  -2.000000E-07   8.000000"});
  });
}

TEST(SurfaceStations, FilesForScec)
{
  test::TemporaryDirectory directory;
  run(directory.path(), "SCEC");
  test::onRankZero([&] {
    const auto on_fault = test::dataLines(directory / "scec/faultst12dp07");
    EXPECT_EQ(on_fault[0], "t h-slip h-slip-rate h-shear-stress v-slip v-slip-rate v-shear-stress "
                           "n-stress log-theta");
    EXPECT_EQ(on_fault[1], " 0.00000000000000E+00   3.800000E+00   6.000000E-01   3.200000E+00"
                           "  -1.900000E+00  -3.000000E-01  -2.200000E+00   2.500000E+01"
                           "   8.000000E+00");
    const auto body = test::dataLines(directory / "scec/bodyinside");
    EXPECT_EQ(body[0], "t h-disp h-vel v-disp v-vel n-disp n-vel");
    EXPECT_EQ(body[1], " 0.00000000000000E+00   4.000000E-01   3.000000E+00   2.100000E+00"
                       "  -2.000000E+00   3.000000E-01   1.000000E+00");
  });
}
