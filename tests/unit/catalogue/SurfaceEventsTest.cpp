#include "catalogue/events/EventCatalogue.hpp"
#include "hdf5/File.hpp"
#include "parameters/Parameters.hpp"
#include "unit/io/BlockMesh.hpp"
#include "unit/io/Stage.hpp"

#include <cmath>

using namespace asperity;
using namespace asperity::catalogue;
using namespace asperity::io;

namespace
{
constexpr double sine = 0.6, cosine = 0.8;

// The base dips along -x by asin(0.6); strike is along z.
Point<3> dipping(Point<3> const& x)
{
  return {cosine * x[0] - sine * x[1], sine * x[0] + cosine * x[1], x[2]};
}

// Where the node was before: (i, k) of the base.
std::array<int, 2> gridPlace(double const* x)
{
  return {static_cast<int>(std::lround(x[0] / cosine)), static_cast<int>(std::lround(x[2]))};
}

// At the times 0 to 3 the nodes slide at `quiet`, but for three that rupture in the steps 1 and 2.
// Slip has the direction (0.6, 0, 0.8) and grows by the trapezoidal rule.
struct Fault : test::Stage
{
  static constexpr double quiet = 1e-4;

  explicit Fault(bool periodic = false) : Stage(test::blockMesh(periodic, dipping))
  {
    add("fault", "slip_rate", 1, [this](double const* x, int) { return rate(x, step); });
    add("fault", "slip", 3, [this](double const* x, int c) {
      const double part[] = {0.6, 0, 0.8};
      double slip = 0;
      for (int i = 1; i <= step; ++i) {
        slip += (rate(x, i - 1) + rate(x, i)) / 2;
      }
      return part[c] * slip;
    });
    add("fault", "shear_modulus", 1, [](double const*, int) { return 3e10; });
  }

  // The nodes (1, 1), (2, 1), (2, 2) rupture, (2, 2) a step later than the others.
  static double rate(double const* x, int step)
  {
    const auto [i, k] = gridPlace(x);
    const bool early = k == 1 && (i == 1 || i == 2);
    const bool late = k == 2 && i == 2;
    return (early && step == 1) || ((early || late) && step == 2) ? (i == 2 ? 2 : 1) : quiet;
  }

  std::unique_ptr<Output> output(std::string const& name, std::filesystem::path const& directory)
  {
    auto const& kind = OutputRegistry::instance().at(name);
    ParameterList list;
    if (name != "Global") {
      list.set("Threshold", 1e-2);
    }
    completeAndValidate(list, *kind.validParameters(), "Test");
    return kind.make(list, context(directory));
  }

  void run(Output& output)
  {
    for (step = 0; step < 4; ++step) {
      output.write(at(step, 1, step == 3));
    }
    output.closeSegment(0);
    output.finish();
  }

  int step = 0;
};

// The part of a step above the threshold 1e-2, from 1e-4 to the rate or back.
double part(double rate) { return 1 - std::log(1e2) / std::log(rate / 1e-4); }

double seismicSlip(double rate, int steps)
{
  return steps * rate + 2 * part(rate) * (rate + Fault::quiet) / 2;
}
} // namespace

TEST(SurfaceEvents, HaveAreaMomentMagnitudeAndHypocentre)
{
  test::TemporaryDirectory directory;
  Fault fault;
  const auto output = fault.output("Event Catalogue", directory.path());
  fault.run(*output);
  auto const& events = dynamic_cast<EventCatalogue const&>(*output).events();
  ASSERT_EQ(events.size(), 1u);
  Event const& event = events[0];
  EXPECT_TRUE(event.isOnSurface() && event.complete);
  EXPECT_NEAR(event.area, 3, 1e-13); // inner nodes of unit squares
  EXPECT_NEAR(event.length, 1, 1e-13);
  EXPECT_NEAR(event.width, 1, 1e-13);
  EXPECT_NEAR(event.peak_slip, seismicSlip(2, 1), 1e-13);
  const double moment = 3e10 * (seismicSlip(1, 1) + seismicSlip(2, 1) + seismicSlip(2, 0));
  EXPECT_NEAR(event.moment, moment, 1e-12 * moment);
  EXPECT_NEAR(event.magnitude(), 2.0 / 3 * (std::log10(moment) - 9.1), 1e-12);
  const std::vector<double> first{2 * cosine, 2 * sine, 1}; // twice as fast as its neighbour
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(event.hypocentre[d], first[d], 1e-15);
  }
  test::onRankZero([&] {
    const auto lines = test::dataLines(directory / "events.csv");
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0], "number,onset [s],end [s],duration [s],area [m^2],length [m],width [m],"
                        "peak_slip [m],peak_slip_rate [m/s],moment [N m],magnitude,"
                        "hypocentre_x [m],hypocentre_y [m],hypocentre_z [m],complete");
    test::expectParts(lines[1], {",3,1,1,", ",1.6,1.2,1,1"});
  });
}

TEST(SurfaceEvents, ARestartGivesTheSameTable)
{
  test::TemporaryDirectory whole, parts;
  Fault fault;
  fault.run(*fault.output("Event Catalogue", whole.path()));
  Archive archive;
  {
    const auto before = fault.output("Event Catalogue", parts.path());
    for (fault.step = 0; fault.step < 2; ++fault.step) {
      before->write(fault.at(fault.step, 1));
    }
    before->closeSegment(0);
    before->save(archive);
  }
  const auto after = fault.output("Event Catalogue", parts.path());
  after->restore(archive);
  for (; fault.step < 4; ++fault.step) {
    after->write(fault.at(fault.step, 1));
  }
  after->finish();
  EXPECT_EQ(test::contents(parts / "events.csv"), test::contents(whole / "events.csv"));
}

TEST(SurfaceEvents, TheTableNamesAreaAndMagnitude)
{
  Event event;
  event.area = 3e8;
  event.moment = std::pow(10, 19.6); // Mw 7
  event.hypocentre = {1, 2, 3};
  std::ostringstream text;
  printEvents(text, {event});
  printSummary(text, summarise({event}));
  test::expectParts(text.str(), {"area [m^2]  Mw", "(1, 2, 3)"});
  EXPECT_TRUE(test::contains(text.str(), "Mw  7  7  7") ||
              test::contains(text.str(), "7      7      7"))
    << text.str();
}

TEST(SurfaceRupture, TimesAtTheNodes)
{
  test::TemporaryDirectory directory;
  Fault fault;
  fault.run(*fault.output("Rupture", directory.path()));
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "rupture.h5");
    const auto times = file.openDataset("rupture_time").read<double>();
    const auto coordinates = file.openDataset("geometry/coordinates").read<double>();
    ASSERT_EQ(times.size(), std::size_t((test::block_nx + 1) * (test::block_nz + 1)));
    ASSERT_EQ(coordinates.size(), 3 * times.size());
    for (std::size_t node = 0; node < times.size(); ++node) {
      const auto [i, k] = gridPlace(&coordinates[3 * node]);
      const double passed = 1 - part(i == 2 ? 2 : 1);
      if (k == 1 && (i == 1 || i == 2)) {
        EXPECT_NEAR(times[node], passed, 1e-13);
      } else if (i == 2 && k == 2) {
        EXPECT_NEAR(times[node], 1 + passed, 1e-13);
      } else {
        EXPECT_TRUE(std::isnan(times[node])) << i << " " << k;
      }
    }
  });
}

TEST(SurfaceGlobal, MomentOfTheWholeFault)
{
  test::TemporaryDirectory directory;
  Fault fault;
  fault.run(*fault.output("Global", directory.path()));
  test::onRankZero([&] {
    const auto lines = test::dataLines(directory / "global.csv");
    ASSERT_EQ(lines.size(), 5u);
    EXPECT_EQ(lines[0], "time [s],peak_slip_rate [m/s],moment_rate [N m/s],moment [N m]");
    // 12 m^2 at 1e-4 m/s; at step 2 three of them at 1, 2 and 2 m/s. Slip then: 1.50005 m twice
    // and 1.00005 m of these, 2e-4 m of the others.
    test::expectParts(lines[1], {"0,0.0001,36000000,0"});
    test::expectParts(lines[3], {"2,2,"});
    const auto comma = lines[3].find_last_of(',');
    EXPECT_NEAR(std::stod(lines[3].substr(4)), 1.50027e11, 1e-4);
    EXPECT_NEAR(std::stod(lines[3].substr(comma + 1)), 1.650615e11, 1e-4);
  });
}
