#include "catalogue/events/EventCatalogue.hpp"
#include "base/Errors.hpp"
#include "parameters/Parameters.hpp"
#include "unit/io/Stage.hpp"

#include <cmath>

using namespace asperity;
using namespace asperity::catalogue;
using namespace asperity::io;
using test::world;

namespace
{
constexpr int num_base = 5; // positions 0, 1/16, 1/4, 9/16, 1
constexpr double threshold = 1e-2;
using Rates = std::vector<double>;                 // of the nodes 0 .. num_base - 1 by position
const Rates shear_moduli{1e6, 2e6, 3e6, 4e6, 5e6}; // [Pa]
using History = std::vector<Rates>;                // at the times 0, 1, 2, ...

// A fault whose rates are prescribed; slip grows by the trapezoidal rule.
struct Observed
{
  explicit Observed(std::filesystem::path const& directory, Rates const& prescribed = {},
                    ParameterList list = {}, Mesh<2> const& mesh = test::stripMesh(num_base))
      : domains{{"fault", boundaryDomain("fault", mesh, "base", world())}}
      , context{directory, world(), fields, domains}
  {
    fields.add({"slip_rate", "m/s", "Slip rate.", "fault", 1,
                [this](std::vector<double>& values) { values = ownedOf(rates); }});
    fields.add({"slip", "m", "Slip.", "fault", 1,
                [this](std::vector<double>& values) { values = ownedOf(slip); }});
    fields.add({"shear_modulus", "Pa", "Shear modulus.", "fault", 1,
                [this](std::vector<double>& values) { values = ownedOf(shear_moduli); }});
    if (!prescribed.empty()) {
      fields.add({"prescribed", "", "Prescribed.", "fault", 1,
                  [=](std::vector<double>& values) { values = ownedOf(prescribed); }});
    }
    fields.add(OutputScalar{"steps", "", "No energy.", [] { return 1.0; }});
    fields.add(OutputScalar{"friction_work", "J/m", "Work.", [this] { return work; }});
    fields.add(OutputScalar{"energy_defect", "J/m", "Defect.", [this] { return -work / 8; }});
    list.set("Threshold", threshold);
    completeAndValidate(list, *EventCatalogue::validParameters(), "Event Catalogue");
    catalogue = std::make_unique<EventCatalogue>(list, context);
  }

  void step(History const& history, std::size_t i)
  {
    if (i > 0) {
      for (int node = 0; node < num_base; ++node) {
        slip[node] += (history[i - 1][node] + history[i][node]) / 2;
      }
    }
    rates = history[i];
    work = static_cast<double>(i * i);
    catalogue->write({static_cast<std::int64_t>(i), double(i), 1, test::peakSlipRate(fields),
                      i + 1 == history.size()});
  }

  std::vector<Event> const& all(History const& history)
  {
    for (std::size_t i = 0; i < history.size(); ++i) {
      step(history, i);
    }
    catalogue->finish();
    return catalogue->events();
  }

  std::vector<double> ownedOf(Rates const& whole) const
  {
    std::vector<double> mine;
    for (const GlobalOrdinal number : domains.at("fault").node_numbers) {
      mine.push_back(whole[number]);
    }
    return mine;
  }

  Rates rates, slip = Rates(num_base, 0);
  double work = 0; // i^2 at step i
  FieldRegistry fields;
  std::map<std::string, OutputDomain> domains;
  OutputContext context;
  std::unique_ptr<EventCatalogue> catalogue;
};

const Rates quiet(num_base, 1e-4);

// One event on the nodes 1 to 3; it begins at node 2.
const History single{quiet,
                     {1e-4, 1e-4, 1.0, 1e-4, 1e-4},
                     {1e-4, 0.5, 2.0, 0.1, 1e-4},
                     {1e-4, 1e-4, 1.0, 1e-4, 1e-4},
                     quiet,
                     quiet};

std::vector<std::string> lines(std::filesystem::path const& file)
{
  std::vector<std::string> lines;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}
} // namespace

TEST(EventCatalogue, MeasuresASingleEvent)
{
  test::TemporaryDirectory directory;
  Observed run(directory.path());
  auto const& events = run.all(single);
  ASSERT_EQ(events.size(), 1u);
  Event const& event = events[0];
  EXPECT_NEAR(event.onset, 0.5, 1e-12); // 1e-4 to 1 passes 1e-2 half way in the logarithm
  EXPECT_NEAR(event.end, 3.5, 1e-12);
  EXPECT_NEAR(event.duration(), 3, 1e-12);
  EXPECT_NEAR(event.width, 9.0 / 16 - 1.0 / 16, 1e-15);
  EXPECT_DOUBLE_EQ(event.peak_slip_rate, 2);
  EXPECT_NEAR(event.nucleation, 0.25, 1e-15);
  EXPECT_TRUE(event.complete);
  // Node 2: two whole steps of 1.5 m, and half of the first and the last one.
  const double of_node_2 = 2 * 1.5 + 2 * 0.5 * (1 + 1e-4) / 2;
  EXPECT_NEAR(event.peak_slip, of_node_2, 1e-12);
  const auto brief = [](double rate) { // up from 1e-4 to the rate and down again
    const double part = 1 - std::log(100.0) / std::log(rate / 1e-4);
    return 2 * part * (rate + 1e-4) / 2;
  };
  const double weight[] = {1.0 / 8, (9.0 - 1) / 32, 3.0 / 8}; // of nodes 1 to 3
  EXPECT_NEAR(event.moment,
              2e6 * weight[0] * brief(0.5) + 3e6 * weight[1] * of_node_2 +
                4e6 * weight[2] * brief(0.1),
              1e-5);
}

// Samples of one and the same history must give one peak, wherever they fall.
TEST(EventCatalogue, ThePeakRateIsBetweenTheSamples)
{
  for (const double peak_at : {1.6, 2.0, 2.3, 2.49}) {
    History history{quiet};
    for (const double time : {1, 2, 3, 4}) {
      const double logarithm = -(time - peak_at) * (time - peak_at) / 8;
      history.push_back({1e-4, 3 * std::exp(logarithm), 0.1, 1e-4, 1e-4});
    }
    history.push_back(quiet);
    test::TemporaryDirectory directory;
    Observed run(directory.path());
    EXPECT_NEAR(run.all(history).at(0).peak_slip_rate, 3, 1e-13) << peak_at;
  }
}

TEST(PeakRate, KeepsTheSampleWhereThePeakIsNotResolved)
{
  EXPECT_EQ(peakRate({0, 1, 2}, {1e-9, 1, 0.9}), 1); // a front passed between two samples
  EXPECT_EQ(peakRate({0, 1, 2}, {0, 1, 0}), 1);
  EXPECT_EQ(peakRate({0, 1, 2}, {1, 1, 1}), 1);
  EXPECT_EQ(peakRate({0, 1, 2}, {1, 2, 3}), 2); // it grows still
  EXPECT_EQ(peakRate({0, 1, 2}, {0, 0, 0}), 0);
}

TEST(PeakRate, UnequalStepsGiveTheSameParabola)
{
  const auto rate = [](double time) { return 4 * std::exp(-3 * (time - 0.1) * (time - 0.1)); };
  EXPECT_NEAR(peakRate({-0.25, 0, 0.5}, {rate(-0.25), rate(0), rate(0.5)}), 4, 1e-14);
  EXPECT_NEAR(peakRate({-0.25, 0.125, 0.25}, {rate(-0.25), rate(0.125), rate(0.25)}), 4, 1e-14);
}

TEST(EventCatalogue, WritesTheTable)
{
  test::TemporaryDirectory directory;
  Observed run(directory.path());
  run.all(single);
  const auto table = lines(directory / "events.csv");
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table[0], "number,onset [s],end [s],duration [s],width [m],peak_slip [m],"
                      "peak_slip_rate [m/s],moment_per_length [N],"
                      "nucleation_from_upper_end [m],complete,"
                      "friction_work [J/m],energy_defect [J/m]");
  EXPECT_EQ(table[1], "1," + exactNumber(run.catalogue->events()[0].onset) + "," +
                        exactNumber(run.catalogue->events()[0].end) + ",3,0.5,3.50005,2," +
                        shortNumber(run.catalogue->events()[0].moment) +
                        ",0.25,1,16,-2"); // from step 0, the last one below, to step 4
}

TEST(EventCatalogue, WhatIsPrescribedIsNoEvent)
{
  Rates creeping = quiet, ruptured = quiet;
  creeping[0] = ruptured[0] = 1;
  ruptured[3] = 0.1;
  test::TemporaryDirectory directory;
  Observed run(directory.path(), {1, 0, 0, 0, 0});
  auto const& events = run.all({creeping, creeping, ruptured, creeping, creeping});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].peak_slip_rate, 0.1);
  EXPECT_EQ(events[0].width, 0);
  EXPECT_NEAR(events[0].nucleation, 9.0 / 16, 1e-15);
  const double slip = 2 * (1 - std::log(100.0) / std::log(1000.0)) * (0.1 + 1e-4) / 2;
  EXPECT_NEAR(events[0].peak_slip, slip, 1e-12);
  EXPECT_NEAR(events[0].moment, 4e6 * 3 / 8 * slip, 1e-6);
}

TEST(EventCatalogue, TheThresholdItselfIsSeismic)
{
  const Rates at(num_base, threshold);
  test::TemporaryDirectory directory;
  Observed run(directory.path());
  auto const& events = run.all({quiet, at, quiet});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(events[0].onset, 1, 1e-12);
  EXPECT_NEAR(events[0].duration(), 0, 1e-12);
  EXPECT_NEAR(events[0].width, 1, 1e-15);
  EXPECT_NEAR(events[0].nucleation, 0, 1e-15); // of equals the one nearest to the first end
}

TEST(EventCatalogue, TouchingRupturesAreOneEvent)
{
  Rates left = quiet, right = quiet, both = quiet;
  left[0] = both[0] = right[4] = both[4] = 1;
  test::TemporaryDirectory directory;
  Observed run(directory.path());
  auto const& events = run.all({quiet, left, both, right, quiet});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(events[0].width, 1, 1e-15);
  EXPECT_NEAR(events[0].duration(), 3, 1e-12);
  EXPECT_NEAR(events[0].nucleation, 0, 1e-15);
}

TEST(EventCatalogue, OneQuietSampleSeparatesTwoEvents)
{
  Rates fast = quiet;
  fast[3] = 1;
  test::TemporaryDirectory directory;
  Observed run(directory.path());
  auto const& events = run.all({quiet, fast, quiet, fast, fast, quiet});
  ASSERT_EQ(events.size(), 2u);
  EXPECT_NEAR(events[0].end, 1.5, 1e-12);
  EXPECT_NEAR(events[1].onset, 2.5, 1e-12);
  EXPECT_NEAR(events[0].peak_slip, 2 * 0.5 * (1 + 1e-4) / 2, 1e-12);
  EXPECT_NEAR(events[1].peak_slip, 1 + 2 * 0.5 * (1 + 1e-4) / 2, 1e-12); // begins at zero again
  EXPECT_EQ(events[1].width, 0);
  EXPECT_NEAR(run.catalogue->summary().recurrence.median, 2, 1e-12);
}

TEST(EventCatalogue, TheFirstNodeToPassIsTheNucleation)
{
  Rates fast = quiet;
  fast[1] = 5; // faster at the sample, but later to pass: it starts from rest
  fast[4] = 1;
  Rates before = quiet;
  before[1] = 0;
  test::TemporaryDirectory directory;
  Observed run(directory.path());
  EXPECT_NEAR(run.all({before, fast, quiet})[0].nucleation, 1, 1e-15);
}

TEST(EventCatalogue, AnEventInProgressAtTheEndIsMarked)
{
  Rates fast = quiet;
  fast[0] = 1;
  test::TemporaryDirectory directory;
  Observed run(directory.path());
  auto const& events = run.all({quiet, fast, fast});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_FALSE(events[0].complete);
  EXPECT_EQ(events[0].end, 2);
  const std::string row = lines(directory / "events.csv").back();
  test::expectParts(row, {",0,4,-0.5"}); // and the work up to the last step
}

TEST(EventCatalogue, ARunMayBeginSeismicAndAtRest)
{
  Rates fast(num_base, 0.0);
  fast[2] = 1;
  test::TemporaryDirectory directory;
  Observed run(directory.path());
  auto const& events = run.all({fast, fast, Rates(num_base, 0.0)});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].onset, 0);
  EXPECT_NEAR(events[0].nucleation, 0.25, 1e-15);
  EXPECT_TRUE(events[0].end > 1 && events[0].end < 1.1); // the rest has a logarithm of -708
}

TEST(EventCatalogue, ARestartAtAnyStepGivesTheSameTable)
{
  History history = single;
  history.insert(history.end(), single.begin(), single.end());
  std::string expected;
  {
    test::TemporaryDirectory directory;
    Observed run(directory.path());
    run.all(history);
    expected = test::contents(directory / "events.csv");
  }
  for (std::size_t stop = 1; stop < history.size(); ++stop) {
    test::TemporaryDirectory directory;
    Archive archive;
    Rates slip;
    {
      Observed before(directory.path());
      for (std::size_t i = 0; i < stop; ++i) {
        before.step(history, i);
      }
      before.catalogue->closeSegment(0);
      before.catalogue->save(archive);
      slip = before.slip;
      before.catalogue->finish(); // stopped by a signal: rows that the restart takes back
    }
    Observed after(directory.path());
    after.slip = slip;
    after.catalogue->restore(archive);
    for (std::size_t i = stop; i < history.size(); ++i) {
      after.step(history, i);
    }
    after.catalogue->finish();
    EXPECT_EQ(test::contents(directory / "events.csv"), expected) << "stopped before " << stop;
    EXPECT_EQ(after.catalogue->events().size(), 2u);
  }
}

namespace
{
// Main events of nodes 1 to 3 at t = 1 and t = 11, each with one of node 0 two steps later.
History mainEventsAndAftershocks()
{
  Rates main = quiet, after = quiet;
  main[1] = main[2] = main[3] = 1;
  after[0] = 0.5;
  History history(20, quiet);
  history[1] = history[11] = main;
  history[3] = history[13] = after;
  return history;
}

ParameterList choice(double merging_time, double smallest_width)
{
  ParameterList list;
  list.set("Merging Time", merging_time);
  list.set("Smallest Width", smallest_width);
  return list;
}
} // namespace

TEST(EventCatalogue, SmallEventsHaveNoRowAndKeepTheirNumbers)
{
  test::TemporaryDirectory directory;
  Observed run(directory.path(), {}, choice(0, 0.1));
  auto const& events = run.all(mainEventsAndAftershocks());
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].number, 1);
  EXPECT_EQ(events[1].number, 3);
  EXPECT_NEAR(run.catalogue->summary().recurrence.median, 10, 1e-12);
  EXPECT_EQ(lines(directory / "events.csv").size(), 3u);
  test::expectParts(run.catalogue->report(), {"and 2 that are left out"});
  EXPECT_EQ(lines(directory / "events.csv")[2].substr(0, 2), "3,");
}

TEST(EventCatalogue, SaysIfTheThresholdHidesEarthquakes)
{
  const Rates creep(num_base, 2 * threshold);
  const std::string above = "slips above 'Event Catalogue / Threshold' = 0.01 m/s at all times",
                    below = "No event: the largest slip rate, 0.0001 m/s, is below";
  for (auto const& history : {History{creep, creep}, {quiet, quiet}, {quiet, creep}}) {
    test::TemporaryDirectory directory;
    Observed run(directory.path());
    run.all(history);
    const auto report = run.catalogue->report();
    EXPECT_EQ(report.find(above) != std::string::npos, history[0] == creep) << report;
    EXPECT_EQ(report.find(below) != std::string::npos, history[1] == quiet) << report;
  }
}

TEST(EventCatalogue, EventsWithinTheMergingTimeAreOne)
{
  test::TemporaryDirectory directory, apart_directory;
  Observed apart(apart_directory.path()), run(directory.path(), {}, choice(3, 0));
  const auto single = apart.all(mainEventsAndAftershocks());
  auto const& events = run.all(mainEventsAndAftershocks());
  ASSERT_EQ(single.size(), 4u);
  ASSERT_EQ(events.size(), 2u);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_EQ(events[i].number, single[2 * i].number);
    EXPECT_EQ(events[i].onset, single[2 * i].onset);
    EXPECT_EQ(events[i].end, single[2 * i + 1].end);
    EXPECT_NEAR(events[i].moment, single[2 * i].moment + single[2 * i + 1].moment, 1e-6);
    EXPECT_NEAR(events[i].width, 9.0 / 16, 1e-15) << "nodes 0 to 3";
    EXPECT_EQ(events[i].peak_slip_rate, 1);
  }
}

TEST(EventCatalogue, TheRunEndsWhenTheLastOfMostEventsIsInTheTable)
{
  const auto history = mainEventsAndAftershocks();
  auto parameters = choice(3, 0);
  parameters.set("Most Events", 1);
  test::TemporaryDirectory directory;
  Observed run(directory.path(), {}, parameters);
  // The first event goes on until node 0 is slow again, at t = 4, and waits for 3 s.
  for (std::size_t i = 0; i < 10; ++i) {
    run.step(history, i);
    EXPECT_EQ(run.catalogue->endsRun(), i >= 7) << "t = " << i << " s";
    EXPECT_EQ(run.catalogue->events().size(), i >= 7 ? 1u : 0u) << "t = " << i << " s";
  }
}

TEST(EventCatalogue, ARestartKeepsAnEventThatWaitsForAnother)
{
  const auto history = mainEventsAndAftershocks();
  test::TemporaryDirectory whole, directory;
  Observed expected(whole.path(), {}, choice(3, 0.1));
  expected.all(history);
  for (std::size_t stop = 1; stop < history.size(); ++stop) {
    Archive archive;
    Observed before(directory.path(), {}, choice(3, 0.1)),
      after(directory.path(), {}, choice(3, 0.1));
    for (std::size_t i = 0; i < stop; ++i) {
      before.step(history, i);
    }
    before.catalogue->closeSegment(0);
    before.catalogue->save(archive);
    after.slip = before.slip;
    after.catalogue->restore(archive);
    for (std::size_t i = stop; i < history.size(); ++i) {
      after.step(history, i);
    }
    after.catalogue->finish();
    EXPECT_EQ(test::contents(directory / "events.csv"), test::contents(whole / "events.csv"))
      << "stopped before " << stop;
  }
}

TEST(EventCatalogue, RefusesAnotherChoiceOnRestartAndMagnitudesInThePlane)
{
  test::TemporaryDirectory directory;
  Archive archive;
  Observed run(directory.path());
  run.catalogue->save(archive);
  Observed other(directory.path(), {}, choice(3, 0));
  test::expectRefusal([&] { other.catalogue->restore(archive); },
                      {"another Merging Time, Smallest Width, Smallest Magnitude or Each Fault"});
  ParameterList magnitude;
  magnitude.set("Smallest Magnitude", 5.0);
  test::expectRefusal([&] { Observed(directory.path(), {}, magnitude); },
                      {"Smallest Magnitude = 5: in two dimensions"});
}

// Node 1 of an upright fault, 1/16 below its upper end, slides first.
TEST(EventCatalogue, NucleationIsTheDepthOnAnUprightFault)
{
  auto mesh = test::stripMesh(num_base);
  for (auto& vertex : mesh.vertices) {
    vertex = {vertex[1], -vertex[0]};
  }
  Rates fast = quiet;
  fast[1] = 1;
  test::TemporaryDirectory directory;
  Observed run(directory.path(), {}, {}, mesh);
  auto const& event = run.all({quiet, fast, quiet}).at(0);
  EXPECT_NEAR(event.nucleation, 1.0 / 16, 1e-15);
  EXPECT_NEAR(event.hypocentre[1], -1.0 / 16, 1e-15);
}

TEST(EventCatalogue, RefusesAnotherThresholdOnRestart)
{
  test::TemporaryDirectory directory;
  test::TemporaryDirectory elsewhere;
  Observed run(directory.path());
  Archive archive;
  run.catalogue->save(archive);
  ParameterList list;
  list.set("Threshold", 2 * threshold);
  completeAndValidate(list, *EventCatalogue::validParameters(), "Event Catalogue");
  EventCatalogue other(list, OutputContext{elsewhere.path(), world(), run.fields, run.domains});
  EXPECT_THROW(other.restore(archive), InputError);
}

TEST(EventCatalogue, TwoComponentsOfSlipCountByTheirMagnitude)
{
  test::TemporaryDirectory directory;
  Observed run(directory.path());
  FieldRegistry fields;
  fields.add(run.fields.field("fault", "slip_rate"));
  fields.add(run.fields.field("fault", "shear_modulus"));
  fields.add({"slip", "m", "Slip.", "fault", 2, [&](std::vector<double>& values) {
                values.clear();
                for (const double slip : run.ownedOf(run.slip)) {
                  values.push_back(0.6 * slip);
                  values.push_back(-0.8 * slip);
                }
              }});
  ParameterList list;
  list.set("Threshold", threshold);
  completeAndValidate(list, *EventCatalogue::validParameters(), "Event Catalogue");
  run.catalogue = std::make_unique<EventCatalogue>(
    list, OutputContext{directory.path(), world(), fields, run.domains});
  EXPECT_NEAR(run.all(single).at(0).peak_slip, 3.50005, 1e-12);
}
