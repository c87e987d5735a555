#include "parameters/Parameters.hpp"
#include "unit/io/Body.hpp"

// All outputs of a run.
using namespace asperity;
using namespace asperity::io;
using test::Body;
using test::num_steps;
using test::world;

namespace
{
namespace fs = std::filesystem;
using Names = std::vector<std::string>;

ParameterList deck()
{
  ParameterList list;
  auto& receivers = list.sublist("Receivers");
  receivers.sublist("On Fault").set("dp001", test::position({0.3, 0}));
  receivers.sublist("Off Fault").set("inside", test::position({0.5, 0.75}));
  receivers.set("Every n Steps", 2);
  list.sublist("Event Catalogue").set("Threshold", 2.0);
  list.sublist("Fault History").set("Every n Steps", 3);
  list.sublist("Volume Snapshots").set("Enabled", true);
  const std::vector<double> times{3.1, 9};
  list.sublist("Volume Snapshots").set("Times", Teuchos::Array<double>(times));
  return list;
}
} // namespace

TEST(Registries, HoldAllOutputs)
{
  EXPECT_EQ(OutputRegistry::instance().names(),
            (Names{"Event Catalogue", "Fault History", "Global", "Receivers", "Rupture",
                   "Step Table", "Surface History", "Volume Snapshots"}));
  const auto valid = OutputSet::validParameters();
  for (auto const& name : OutputRegistry::instance().names()) {
    EXPECT_TRUE(valid->sublist(name).isParameter("Enabled")) << name;
  }
}

namespace
{
// The data in a directory of two runs is the same; the histories by their values.
void expectSameData(fs::path const& broken, fs::path const& whole, Names const& texts)
{
  for (auto const& name : texts) {
    EXPECT_EQ(test::contents(broken / name), test::contents(whole / name)) << name;
    EXPECT_NE(test::contents(whole / name), "") << name;
  }
  const std::map<std::string, Names> datasets{
    {"fault.h5",
     {"time", "peak_slip_rate", "fields/slip_rate", "fields/alpha", "fields/slip",
      "fields/traction"}},
    {"surface.h5", {"time", "fields/displacement"}},
    {"volume.h5", {"time", "fields/displacement"}},
    {"receivers.h5",
     {"time", "step", "on_fault/fields/slip", "on_fault/fields/theta",
      "off_fault/fields/velocity"}},
    {"rupture.h5", {"number", "onset", "rupture_time", "first_rupture_time"}}};
  for (auto const& [file, names] : datasets) {
    for (auto const& name : names) {
      const auto expected = test::readNumbers(whole / file, name);
      EXPECT_EQ(test::readNumbers(broken / file, name), expected) << file << " " << name;
      EXPECT_FALSE(expected.empty()) << file << " " << name;
    }
  }
}

} // namespace

TEST(OutputSet, AKilledAndRestartedRunLeavesTheSameData)
{
  test::TemporaryDirectory whole, broken;
  {
    Body body;
    OutputSet outputs(deck(), {whole.path(), world(), body.fields, body.domains});
    test::steps(outputs, body, whole.path(), 0, num_steps + 1);
    test::finish(outputs, body, whole.path());
    EXPECT_EQ(outputs.numEvents(), 3);
    test::expectParts(outputs.report(), {"\n3 events\n"});
  }
  {
    Body body;
    OutputSet outputs(deck(), {broken.path(), world(), body.fields, body.domains});
    test::steps(outputs, body, broken.path(), 0,
                40); // checkpoint after step 24, killed after step 39
  }
  {
    Body body;
    OutputSet outputs(deck(), {broken.path(), world(), body.fields, body.domains});
    const Archive archive = readCheckpoint(
      broken / "checkpoint.h5", Fingerprint{{{"Asperity", "deck", ""}}}, *world(), body.nodeSets());
    outputs.restore(archive.child("outputs"));
    test::steps(outputs, body, broken.path(), 25, num_steps + 1);
    test::finish(outputs, body, broken.path());
  }
  test::onRankZero([&] {
    expectSameData(
      broken.path(), whole.path(),
      {"steps.csv", "events.csv", "global.csv", "fault.xdmf", "surface.xdmf", "volume.xdmf"});
  });
}
