#include "base/Parameters.hpp"
#include "io/Checkpoint.hpp"
#include "io/H5.hpp"
#include "io/OutputSet.hpp"
#include "io/outputs/EventCatalogue.hpp"
#include "unit/io/Support.hpp"

#include <cmath>

using namespace asperity;
using namespace asperity::io;
using test::world;

namespace
{
constexpr int num_base = 6, num_steps = 60;
namespace fs = std::filesystem;

// A body that shakes as a function of the time, with everything that the default outputs ask for.
struct Body
{
  Body()
  {
    const auto mesh = test::stripMesh(num_base);
    locations["fault"] = boundaryLocation("fault", mesh, "base", world());
    locations["surface"] = boundaryLocation("surface", mesh, "surface", world());
    locations["volume"] = volumeLocation(mesh, world());
    addField("fault", "slip_rate", 1, [this](double x) { return rate(x); });
    addField("fault", "alpha", 1, [this](double x) { return x - time; });
    addField("fault", "slip", 1, [this](double x) { return time * x; });
    addField("fault", "traction", 1, [this](double x) { return 1e6 * x + time; });
    addField("surface", "displacement", 2, [this](double x) { return time + x; });
    addField("volume", "displacement", 2, [this](double x) { return time - x; });
    fields.add(
      Scalar{"fixed_point_iterations", "", "Test.", [this] { return 2 + std::floor(time); }});
    fields.add(Scalar{"kinetic_energy", "J", "Test.", [this] { return time / 3; }});
  }

  double rate(double x) const { return std::exp(3 * std::sin(time) * (1 - x)); }

  void addField(std::string const& location, std::string const& name, int components,
                std::function<double(double)> const& value)
  {
    Location const& nodes = locations.at(location);
    fields.add({name, "1", "Test.", location, components, [=, &nodes](std::vector<double>& values) {
                  values.clear();
                  for (std::size_t i = 0; i < nodes.numOwned(); ++i) {
                    values.insert(values.end(), components, value(nodes.coordinates[2 * i]));
                  }
                }});
  }

  StepInfo at(int step)
  {
    time = step / 4.0;
    return {step, time, 0.25, rate(0), step == num_steps};
  }

  double time = 0;
  FieldRegistry fields;
  std::map<std::string, Location> locations;
};

ParameterList deck()
{
  ParameterList list;
  list.sublist("Event Catalogue").set("Threshold", 2.0);
  list.sublist("Fault History").set("Every n Steps", 3);
  list.sublist("Volume Snapshots").set("Enabled", true);
  const std::vector<double> times{3.1, 9};
  list.sublist("Volume Snapshots").set("Times", Teuchos::Array<double>(times));
  return list;
}

void checkpoint(OutputSet& outputs, fs::path const& directory)
{
  outputs.closeSegment();
  Archive archive;
  archive.insert("outputs", outputs.save());
  writeCheckpoint(directory / "checkpoint.h5", archive, "deck", *world());
}

void steps(OutputSet& outputs, Body& body, fs::path const& directory, int first, int end)
{
  for (int step = first; step < end; ++step) {
    outputs.write(body.at(step));
    if (step % 25 == 24) {
      checkpoint(outputs, directory);
    }
  }
}

void finish(OutputSet& outputs, fs::path const& directory)
{
  checkpoint(outputs, directory);
  outputs.finish();
}

std::vector<double> values(fs::path const& file, std::string const& dataset)
{
  return h5::File::open(file).openDataset(dataset).readDoubles();
}
} // namespace

TEST(OutputRegistry, HoldsTheOutputs)
{
  EXPECT_EQ(OutputRegistry::instance().names(),
            (std::vector<std::string>{"Event Catalogue", "Fault History", "Step Table",
                                      "Surface History", "Volume Snapshots"}));
  const auto valid = OutputSet::validParameters();
  for (auto const& name : OutputRegistry::instance().names()) {
    EXPECT_TRUE(valid->sublist(name).isParameter("Enabled")) << name;
  }
}

TEST(OutputSet, AKilledAndRestartedRunLeavesTheSameData)
{
  test::TemporaryDirectory whole, broken;
  {
    Body body;
    OutputSet outputs(deck(), {whole.path(), world(), body.fields, body.locations});
    steps(outputs, body, whole.path(), 0, num_steps + 1);
    finish(outputs, whole.path());
    EXPECT_EQ(outputs.events()->summary().num_events, 3);
  }
  {
    Body body;
    OutputSet outputs(deck(), {broken.path(), world(), body.fields, body.locations});
    steps(outputs, body, broken.path(), 0, 40); // checkpoint after step 24, killed after step 39
  }
  {
    Body body;
    OutputSet outputs(deck(), {broken.path(), world(), body.fields, body.locations});
    const Archive archive = readCheckpoint(broken / "checkpoint.h5", "deck", *world());
    outputs.restore(archive.child("outputs"));
    steps(outputs, body, broken.path(), 25, num_steps + 1);
    finish(outputs, broken.path());
  }
  test::onRankZero([&] {
    for (auto const& name :
         {"steps.csv", "events.csv", "fault.xdmf", "surface.xdmf", "volume.xdmf"}) {
      EXPECT_EQ(test::contents(broken / name), test::contents(whole / name)) << name;
    }
    const std::map<std::string, std::vector<std::string>> fields{
      {"fault.h5", {"slip_rate", "alpha", "slip", "traction"}},
      {"surface.h5", {"displacement"}},
      {"volume.h5", {"displacement"}}};
    for (auto const& [file, names] : fields) {
      EXPECT_EQ(values(broken / file, "time"), values(whole / file, "time"));
      for (auto const& name : names) {
        EXPECT_EQ(values(broken / file, "fields/" + name), values(whole / file, "fields/" + name));
      }
    }
  });
}

TEST(OutputSet, WritesRowsWhereTheDeckAsks)
{
  test::TemporaryDirectory directory;
  Body body;
  OutputSet outputs(deck(), {directory.path(), world(), body.fields, body.locations});
  steps(outputs, body, directory.path(), 0, num_steps + 1);
  finish(outputs, directory.path());
  test::onRankZero([&] {
    EXPECT_EQ(values(directory / "volume.h5", "time"), (std::vector<double>{0, 3.25, 9, 15}));
    std::ifstream table(directory / "steps.csv");
    std::string header, first;
    std::getline(table, header);
    std::getline(table, first);
    EXPECT_EQ(header, "step,time [s],step_size [s],peak_slip_rate [m/s],fixed_point_iterations,"
                      "kinetic_energy [J]");
    EXPECT_EQ(first, "1,0.25,0.25," + shortNumber(std::exp(3 * std::sin(0.25))) + ",2,0.083333333");
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
  const std::map<std::string, Location> nowhere;
  OutputSet outputs(list, {directory.path(), world(), nothing, nowhere});
  outputs.write({1, 0.5, 0.5, 1e-9, true});
  outputs.finish();
  EXPECT_EQ(outputs.events(), nullptr);
  test::onRankZero([&] {
    EXPECT_EQ(test::contents(directory / "steps.csv"),
              "step,time [s],step_size [s],peak_slip_rate [m/s]\n1,0.5,0.5,1e-09\n");
  });
  const auto files = fs::directory_iterator(directory.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST(OutputSet, MistakesInTheDeckAreNamed)
{
  test::TemporaryDirectory directory;
  Body body;
  const auto error = [&](ParameterList const& list) {
    return test::inputError(
      [&] { OutputSet(list, {directory.path(), world(), body.fields, body.locations}); });
  };
  ParameterList unknown;
  unknown.sublist("Fault History").set("Every n Step", 3);
  EXPECT_TRUE(test::contains(error(unknown), "Every n Steps")) << error(unknown);
  ParameterList negative;
  negative.sublist("Event Catalogue").set("Threshold", -1.0);
  EXPECT_TRUE(test::contains(error(negative), "Threshold = -1")) << error(negative);
  ParameterList field;
  field.sublist("Fault History").set("Fields", Teuchos::Array<std::string>(1, "slip_rat"));
  EXPECT_TRUE(test::contains(error(field), "Did you mean 'slip_rate'?")) << error(field);
  body.locations.erase("surface");
  EXPECT_TRUE(test::contains(error(ParameterList()), "this problem has no surface"));
}
