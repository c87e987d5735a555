#include "io/files/TextTable.hpp"
#include "parameters/Parameters.hpp"
#include "unit/io/Body.hpp"

using namespace asperity;
using namespace asperity::io;
using test::Body;
using test::num_steps;
using test::world;

namespace
{
namespace fs = std::filesystem;

ParameterList deck()
{
  ParameterList list;
  list.sublist("Fault History").set("Every n Steps", 3);
  list.sublist("Volume Snapshots").set("Enabled", true);
  const std::vector<double> times{3.1, 9};
  list.sublist("Volume Snapshots").set("Times", Teuchos::Array<double>(times));
  return list;
}

using Names = std::vector<std::string>;

} // namespace

TEST(OutputRegistry, HoldsTheOutputs)
{
  EXPECT_EQ(OutputRegistry::instance().names(),
            (Names{"Fault History", "Step Table", "Surface History", "Volume Snapshots"}));
  const auto valid = OutputSet::validParameters();
  for (auto const& name : OutputRegistry::instance().names()) {
    EXPECT_TRUE(valid->sublist(name).isParameter("Enabled")) << name;
  }
}

TEST(OutputSet, WritesRowsWhereTheDeckAsks)
{
  test::TemporaryDirectory directory;
  Body body;
  OutputSet outputs(deck(), {directory.path(), world(), body.fields, body.domains});
  test::steps(outputs, body, directory.path(), 0, num_steps + 1);
  test::finish(outputs, body, directory.path());
  test::onRankZero([&] {
    EXPECT_EQ(test::readNumbers(directory / "volume.h5", "time"),
              (std::vector<double>{0, 3.25, 9, 15}));
    const auto rates = test::readNumbers(directory / "volume.h5", "peak_slip_rate");
    ASSERT_EQ(rates.size(), 4u);
    EXPECT_EQ(rates[1], std::exp(3 * std::sin(3.25)));
    std::ifstream table(directory / "steps.csv");
    std::string header, first;
    std::getline(table, header);
    std::getline(table, first);
    EXPECT_EQ(header, "step,time [s],step_size [s],peak_slip_rate [m/s],wall_time [s],"
                      "fixed_point_iterations,kinetic_energy [J]");
    EXPECT_EQ(first,
              "1,0.25,0.25," + shortNumber(std::exp(3 * std::sin(0.25))) + ",0.125,2,0.083333333");
    const std::string text = test::contents(directory / "steps.csv");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), num_steps + 1);
  });
}

TEST(OutputSet, DisabledOutputsLeaveNothing)
{
  test::TemporaryDirectory directory;
  ParameterList list;
  for (auto const& name : OutputRegistry::instance().names()) {
    list.sublist(name).set("Enabled", name == "Step Table");
  }
  const FieldRegistry nothing;
  const std::map<std::string, OutputDomain> nowhere;
  OutputSet outputs(list, {directory.path(), world(), nothing, nowhere});
  outputs.write({1, 0.5, 0.5, 1e-9, true, 37.25});
  outputs.finish();
  EXPECT_FALSE(outputs.numEvents());
  EXPECT_EQ(outputs.report(), "");
  test::onRankZero([&] {
    EXPECT_EQ(test::contents(directory / "steps.csv"),
              "step,time [s],step_size [s],peak_slip_rate [m/s],wall_time [s]\n"
              "1,0.5,0.5,1e-09,37.25\n");
  });
  const auto files = fs::directory_iterator(directory.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST(OutputSet, MistakesInTheDeckAreNamed)
{
  test::TemporaryDirectory directory;
  Body body;
  const auto error = [&](ParameterList const& list) {
    return test::refusal([&] {
      OutputSet(list, {directory.path(), world(), body.fields, body.domains});
    });
  };
  ParameterList unknown;
  unknown.sublist("Fault History").set("Every n Step", 3);
  test::expectParts(error(unknown), {"Every n Steps"});
  ParameterList negative;
  negative.sublist("Fault History").set("Every n Steps", -1);
  test::expectParts(error(negative), {"Every n Steps = -1"});
  ParameterList field;
  field.sublist("Fault History").set("Fields", Teuchos::Array<std::string>(1, "slip_rat"));
  test::expectParts(error(field), {"Did you mean 'slip_rate'?"});
  ParameterList twice;
  const Names slip_twice{"slip", "alpha", "slip"};
  twice.sublist("Fault History").set("Fields", Teuchos::Array<std::string>(slip_twice));
  test::expectParts(error(twice), {"for the fault names 'slip' twice"});
}

TEST(OutputSet, AKindWhoseDomainTheRunHasNotIsLeftOut)
{
  test::TemporaryDirectory directory;
  Body body;
  body.domains.erase("surface");
  const ParameterList given = deck();
  // The copy shall stay as it is. NOLINTNEXTLINE(performance-unnecessary-copy*)
  ParameterList list = given;
  OutputSet outputs(list, {directory.path(), world(), body.fields, body.domains});
  test::steps(outputs, body, directory.path(), 0, num_steps + 1);
  test::finish(outputs, body, directory.path());
  EXPECT_TRUE(fs::exists(directory / "fault.h5"));
  EXPECT_FALSE(fs::exists(directory / "surface.h5"));
  EXPECT_TRUE(outputs.leftOut().empty()) << "the deck does not ask for it";
  ParameterList asks = given;
  asks.sublist("Surface History").set("Every n Steps", 3);
  const OutputSet without(asks, {directory.path(), world(), body.fields, body.domains});
  ASSERT_EQ(without.leftOut().size(), 1u);
  EXPECT_EQ(without.leftOut()[0].name, "Surface History");
  EXPECT_EQ(without.leftOut()[0].domain, "surface");
  EXPECT_TRUE(Teuchos::haveSameValues(list, given));
}
