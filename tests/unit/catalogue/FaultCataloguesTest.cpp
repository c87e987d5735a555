#include "catalogue/events/EventCatalogue.hpp"
#include "catalogue/events/EventTable.hpp"
#include "mesh/Boundaries.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "parameters/Parameters.hpp"
#include "unit/io/BlockMesh.hpp"
#include "unit/io/Stage.hpp"

#include <cmath>
#include <map>
#include <sstream>

using namespace asperity;
using namespace asperity::catalogue;
using namespace asperity::io;

namespace
{
constexpr double quiet = 1e-4, modulus = 3e10;
const std::vector<std::string> names{"main", "splay"};

// The base is cut at x = `cut` into two boundaries, of which the first has the nodes between them.
template <int Dim>
Mesh<Dim> cutBase(Mesh<Dim> mesh, double cut)
{
  mesh.boundaries.insert({{names[0], {}}, {names[1], {}}}); // on every rank
  for (auto const& facet : mesh.boundaries.at("base")) {
    const bool is_main = mesh::centroid(mesh::corners(mesh, facet))[0] < cut;
    mesh.boundaries[names[is_main ? 0 : 1]].push_back(facet);
  }
  mesh.boundaries["base"] = mesh.boundaries.at(mesh::joinBoundaries(mesh, names));
  return mesh;
}

// Nodes slide at `quiet` but for those that `fast` names, by a number of the node, in some steps of
// 1 s; slip grows by the trapezoidal rule.
struct TwoFaults : test::Stage
{
  using Rates = std::map<int, double>; // of the fast nodes
  using NodeAt = std::function<int(double const*)>;

  template <int Dim>
  TwoFaults(Mesh<Dim> const& mesh, NodeAt const& node_at, std::vector<Rates> const& fast)
      : Stage(mesh)
      , num_steps(static_cast<int>(fast.size()))
  {
    nameParts(domains.at("fault"), mesh, names);
    const auto rate = [=](double const* x, int i) {
      const auto found = fast[i].find(node_at(x));
      return found == fast[i].end() ? quiet : found->second;
    };
    add("fault", "slip_rate", 1, [this, rate](double const* x, int) { return rate(x, step); });
    add("fault", "slip", 1, [this, rate](double const* x, int) {
      double slip = 0;
      for (int i = 1; i <= step; ++i) {
        slip += (rate(x, i - 1) + rate(x, i)) / 2;
      }
      return slip;
    });
    add("fault", "shear_modulus", 1, [](double const*, int) { return modulus; });
    fields.add(OutputScalar{"friction_work", "J/m", "Work.", [] { return 1.0; }});
  }

  EventCatalogue catalogue(std::filesystem::path const& directory, ParameterList list = {}) const
  {
    list.set("Threshold", 1e-2).set("Each Fault", true);
    completeAndValidate(list, *EventCatalogue::validParameters(), "Event Catalogue");
    return {list, context(directory)};
  }

  void write(EventCatalogue& catalogue, int begin, int end)
  {
    for (step = begin; step < end; ++step) {
      catalogue.write(at(step, 1));
    }
  }

  void run(std::filesystem::path const& directory, ParameterList const& list = {})
  {
    auto output = catalogue(directory, list);
    write(output, 0, num_steps);
    output.finish();
  }

  int num_steps, step = 0;
};

// On the strip, whose nodes 0 to 4 lie at 0, 1/16, 1/4, 9/16 and 1: main has the nodes 0 to 2.
int nodeOfStrip(double const* x) { return static_cast<int>(std::lround(4 * std::sqrt(x[0]))); }

TwoFaults strip(std::vector<TwoFaults::Rates> const& fast)
{
  return {cutBase(test::stripMesh(5), 0.25), nodeOfStrip, fast};
}

// A rupture that begins on main and jumps to splay.
const std::vector<TwoFaults::Rates> jump{{},       {{1, 1}},         {{1, 1}, {2, 1}},
                                         {{3, 2}}, {{3, 2}, {4, 1}}, {}};

// A table without units in its headings: rows of values by column.
std::vector<std::map<std::string, double>> table(std::filesystem::path const& file)
{
  std::vector<std::map<std::string, double>> rows;
  std::vector<std::string> columns;
  for (auto const& line : test::dataLines(file)) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(cell.substr(0, cell.find(' ')));
    }
    if (columns.empty()) {
      columns = row;
      continue;
    }
    rows.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      rows.back()[columns[i]] = std::stod(row[i]);
    }
  }
  return rows;
}

// When a rate passes 1e-2 on its way up from `quiet` within a second, and the slip while above.
double passed(double rate) { return std::log(1e2) / std::log(rate / quiet); }
double ramp(double rate) { return (1 - passed(rate)) * (rate + quiet) / 2; }

constexpr double digits = 1e-7; // tables have 8
} // namespace

TEST(FaultCatalogues, ARuptureThatJumpsIsOneEventOfEachFault)
{
  test::TemporaryDirectory directory;
  strip(jump).run(directory.path());
  test::onRankZero([&] {
    const auto all = table(directory / "events.csv"), main = table(directory / "events_main.csv"),
               splay = table(directory / "events_splay.csv");
    ASSERT_EQ(all.size(), 1u);
    ASSERT_EQ(main.size(), 1u);
    ASSERT_EQ(splay.size(), 1u);
    const auto expectEvent = [](auto const& event, std::map<std::string, double> const& expected) {
      for (auto const& [name, value] : expected) {
        EXPECT_NEAR(event.at(name), value, digits * value) << name;
      }
    };
    const double up = passed(1), up_2 = passed(2);
    // Half the length of the segments beside the nodes 1 to 4.
    const double w1 = 1. / 8, w2 = 1. / 4, w3 = 3. / 8, w4 = 7. / 32;
    const double of_main = modulus * (w1 * (1 + 2 * ramp(1)) + w2 * 2 * ramp(1));
    const double of_splay = modulus * (w3 * (2 + 2 * ramp(2)) + w4 * 2 * ramp(1));
    expectEvent(main[0], {{"number", 1},
                          {"onset", up},
                          {"end", 3 - up},
                          {"width", 3. / 16},
                          {"peak_slip", 1 + 2 * ramp(1)},
                          {"peak_slip_rate", 1},
                          {"moment_per_length", of_main},
                          {"nucleation_from_upper_end", 1. / 16},
                          {"complete", 1}});
    expectEvent(splay[0], {{"number", 1},
                           {"onset", 2 + up_2},
                           {"end", 5 - up_2},
                           {"width", 7. / 16},
                           {"peak_slip", 2 + 2 * ramp(2)},
                           {"peak_slip_rate", 2},
                           {"moment_per_length", of_splay},
                           {"nucleation_from_upper_end", 9. / 16},
                           {"complete", 1}});
    expectEvent(all[0], {{"number", 1},
                         {"onset", up},
                         {"end", 5 - up_2},
                         {"width", 15. / 16},
                         {"moment_per_length", of_main + of_splay}});
    EXPECT_EQ(all[0].count("friction_work"), 1u);
    EXPECT_EQ(main[0].count("friction_work"), 0u); // of the whole body
  });
}

TEST(FaultCatalogues, ARestartAtAnyStepGivesTheSameTables)
{
  test::TemporaryDirectory whole;
  auto fault = strip(jump);
  fault.run(whole.path());
  for (int stop = 1; stop < fault.num_steps; ++stop) {
    test::TemporaryDirectory directory;
    Archive archive;
    {
      auto before = fault.catalogue(directory.path());
      fault.write(before, 0, stop);
      before.closeSegment(0);
      before.save(archive);
      before.finish(); // rows that the restart takes back
    }
    auto after = fault.catalogue(directory.path());
    after.restore(archive);
    fault.write(after, stop, fault.num_steps);
    after.finish();
    for (auto const* file : {"events.csv", "events_main.csv", "events_splay.csv"}) {
      EXPECT_EQ(test::contents(directory / file), test::contents(whole / file))
        << file << ", stopped before " << stop;
    }
  }
}

// Main breaks, rests while splay breaks on, and breaks again; then splay alone by itself.
TEST(FaultCatalogues, RowsHaveTheNumberOfTheEventInWhichTheFaultTakesPart)
{
  const std::vector<TwoFaults::Rates> fast{
    {}, {{1, 1}, {3, 1}}, {{3, 1}, {4, 1}}, {{3, 1}}, {{1, 1}}, {}, {}, {}, {{3, 1}}, {}};
  const auto numbers = [](std::filesystem::path const& file) {
    std::vector<int> result;
    for (auto const& row : table(file)) {
      result.push_back(static_cast<int>(row.at("number")));
    }
    return result;
  };
  const auto expectNumbers = [&](ParameterList const& list, std::vector<int> const& all,
                                 std::vector<int> const& main, std::vector<int> const& splay) {
    test::TemporaryDirectory directory;
    strip(fast).run(directory.path(), list);
    test::onRankZero([&] {
      EXPECT_EQ(numbers(directory / "events.csv"), all);
      EXPECT_EQ(numbers(directory / "events_main.csv"), main);
      EXPECT_EQ(numbers(directory / "events_splay.csv"), splay);
    });
  };
  expectNumbers({}, {1, 2}, {1, 1}, {1, 2});
  ParameterList merged, wide;
  merged.set("Merging Time", 2.5); // main rests for 2 s, splay for 4
  expectNumbers(merged, {1, 2}, {1}, {1, 2});
  wide.set("Smallest Width", 0.1); // main breaks at a single node
  expectNumbers(wide, {1}, {}, {1});
}

// Main is level and splay rises by asin(0.6) from x = 2 on; unit squares along both.
TEST(FaultCatalogues, OnSurfacesEachFaultHasItsAreaMagnitudeAndPlane)
{
  const auto bent = [](Point<3> const& x) {
    const double s = x[0] - 2;
    return s <= 0 ? x : Point<3>{2 + 0.8 * s - 0.6 * x[1], 0.6 * s + 0.8 * x[1], x[2]};
  };
  const auto node_at = [](double const* x) { // 10 i + k of the grid
    const double i = x[0] <= 2 ? x[0] : 2 + (x[0] - 2) / 0.8;
    return 10 * static_cast<int>(std::lround(i)) + static_cast<int>(std::lround(x[2]));
  };
  TwoFaults fault(cutBase(test::blockMesh(false, bent), 2), node_at,
                  {{}, {{11, 1}, {12, 1}}, {{11, 1}, {31, 2}, {41, 1}}, {{31, 2}}, {}});
  test::TemporaryDirectory directory;
  fault.run(directory.path());
  test::onRankZero([&] {
    const auto all = table(directory / "events.csv").at(0),
               main = table(directory / "events_main.csv").at(0),
               splay = table(directory / "events_splay.csv").at(0);
    const double r = ramp(1); // nodes (1, 1), (1, 2) and (3, 1) have 1 m^2, (4, 1) a half
    const double of_main = modulus * ((1 + 2 * r) + 2 * r);
    const double of_splay = modulus * ((2 + 2 * ramp(2)) + 0.5 * 2 * r);
    EXPECT_NEAR(main.at("area"), 2, digits);
    EXPECT_NEAR(splay.at("area"), 1.5, digits);
    EXPECT_NEAR(all.at("area"), 3.5, digits);
    EXPECT_NEAR(main.at("length") + main.at("width"), 1, digits); // along z
    EXPECT_NEAR(splay.at("length"), 0, digits);
    EXPECT_NEAR(splay.at("width"), 1, digits); // in the plane of splay, not of both
    EXPECT_NEAR(main.at("moment"), of_main, digits * of_main);
    EXPECT_NEAR(splay.at("moment"), of_splay, digits * of_splay);
    EXPECT_NEAR(all.at("moment"), of_main + of_splay, digits * of_main);
    EXPECT_NEAR(splay.at("magnitude"), 2. / 3 * (std::log10(of_splay) - 9.1), digits * 10);
    EXPECT_NEAR(splay.at("onset"), 1 + passed(2), digits);
    EXPECT_NEAR(splay.at("hypocentre_x"), 2.8, digits);
    EXPECT_NEAR(splay.at("hypocentre_y"), 0.6, digits);
  });
}

TEST(FaultCatalogues, ASingleFaultIsRefused)
{
  test::TemporaryDirectory directory;
  auto fault = strip(jump);
  fault.domains.at("fault").boundaries.clear();
  test::expectRefusal([&] { fault.catalogue(directory.path()); },
                      {"Event Catalogue / Each Fault is true", "one boundary alone"});
}

TEST(FaultCatalogues, FilesHaveSafeAndDifferentNames)
{
  EXPECT_EQ(eventFiles({"main", "a/b", "a b", "../x", "San Andreas-1.5"}),
            (std::vector<std::string>{"events_main.csv", "events_a_b.csv", "events_a_b_.csv",
                                      "events_.._x.csv", "events_San_Andreas-1.5.csv"}));
}
