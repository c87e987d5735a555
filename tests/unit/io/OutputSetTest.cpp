#include "io/OutputSet.hpp"
#include "base/hdf5/File.hpp"
#include "base/parameters/Parameters.hpp"
#include "io/catalogue/events/EventCatalogue.hpp"
#include "io/checkpoint/Checkpoint.hpp"
#include "unit/io/Stage.hpp"

#include <cmath>

using namespace asperity;
using namespace asperity::io;
using test::world;

namespace
{
const Fingerprint of_tests = {{{"Asperity", "deck", ""}}};

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
    addField("fault", "normal_stress", 1, [](double x) { return 1e7 * x; });
    addField("fault", "theta", 1, [this](double x) { return std::exp(x - time); });
    addField("fault", "shear_modulus", 1, [](double) { return 3e10; });
    addField("surface", "displacement", 2, [this](double x) { return time + x; });
    addField("volume", "displacement", 2, [this](double x) { return time - x; });
    addField("volume", "velocity", 2, [](double x) { return 1 + x; });
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

ParameterList deck(std::string const& text_format = "None")
{
  ParameterList list;
  list.set("Text Format", text_format);
  if (text_format != "None") {
    list.sublist(text_format).set("Date", "2024/05/31");
  }
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

void checkpoint(OutputSet& outputs, fs::path const& directory)
{
  outputs.closeSegment();
  Archive archive;
  archive.insert("outputs", outputs.save());
  writeCheckpoint(directory / "checkpoint.h5", archive, of_tests, *world());
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

using Names = std::vector<std::string>;

std::vector<double> values(fs::path const& file, std::string const& dataset)
{
  return h5::File::open(file).openDataset(dataset).read<double>();
}
} // namespace

TEST(OutputRegistry, HoldsTheOutputs)
{
  EXPECT_EQ(
    OutputRegistry::instance().names(),
    (std::vector<std::string>{"Event Catalogue", "Fault History", "Global", "Receivers", "Rupture",
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
    {"fault.h5", {"time", "fields/slip_rate", "fields/alpha", "fields/slip", "fields/traction"}},
    {"surface.h5", {"time", "fields/displacement"}},
    {"volume.h5", {"time", "fields/displacement"}},
    {"receivers.h5",
     {"time", "step", "on_fault/fields/slip", "on_fault/fields/theta",
      "off_fault/fields/velocity"}},
    {"rupture.h5", {"number", "onset", "rupture_time", "first_rupture_time"}}};
  for (auto const& [file, names] : datasets) {
    for (auto const& name : names) {
      const auto expected = values(whole / file, name);
      EXPECT_EQ(values(broken / file, name), expected) << file << " " << name;
      EXPECT_FALSE(expected.empty()) << file << " " << name;
    }
  }
}

void expectRestartsExactly(std::string const& text_format, Names const& more_texts)
{
  test::TemporaryDirectory whole, broken;
  {
    Body body;
    OutputSet outputs(deck(text_format), {whole.path(), world(), body.fields, body.locations});
    steps(outputs, body, whole.path(), 0, num_steps + 1);
    finish(outputs, whole.path());
    EXPECT_EQ(outputs.events()->summary().num_events, 3);
  }
  {
    Body body;
    OutputSet outputs(deck(text_format), {broken.path(), world(), body.fields, body.locations});
    steps(outputs, body, broken.path(), 0, 40); // checkpoint after step 24, killed after step 39
  }
  {
    Body body;
    OutputSet outputs(deck(text_format), {broken.path(), world(), body.fields, body.locations});
    const Archive archive = readCheckpoint(broken / "checkpoint.h5", of_tests, *world());
    outputs.restore(archive.child("outputs"));
    steps(outputs, body, broken.path(), 25, num_steps + 1);
    finish(outputs, broken.path());
  }
  test::onRankZero([&] {
    Names texts{"steps.csv",  "events.csv",   "global.csv",
                "fault.xdmf", "surface.xdmf", "volume.xdmf"};
    texts.insert(texts.end(), more_texts.begin(), more_texts.end());
    expectSameData(broken.path(), whole.path(), texts);
  });
}
} // namespace

TEST(OutputSet, AKilledAndRestartedRunLeavesTheSameData) { expectRestartsExactly("None", {}); }

TEST(OutputSet, AndTheSameFilesForThePlatforms)
{
  expectRestartsExactly("SEAS", {"seas/fltst_dp001", "seas/blkst_inside", "seas/global.dat",
                                 "seas/rupture.dat", "seas/slip.dat"});
  expectRestartsExactly("SCEC", {"scec/faultdp001", "scec/bodyinside", "scec/cplot"});
}

TEST(OutputSet, ARestartForAnotherPlatformIsRefused)
{
  test::TemporaryDirectory directory;
  Body body;
  const OutputContext context{directory.path(), world(), body.fields, body.locations};
  for (auto const& [earlier, now] :
       {std::pair("None", "SEAS"), std::pair("SCEC", "SEAS"), std::pair("SEAS", "None")}) {
    const Archive archive = OutputSet(deck(earlier), context).save();
    OutputSet after(deck(now), context);
    const auto message = test::inputError([&] { after.restore(archive); });
    EXPECT_TRUE(test::contains(message, std::string("Text Format is ") + now + ", but it was " +
                                          earlier + " in the run"))
      << message;
  }
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
    return test::inputError([&] {
      OutputSet(list, {directory.path(), world(), body.fields, body.locations});
    });
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
  ParameterList twice;
  const Names slip_twice{"slip", "alpha", "slip"};
  twice.sublist("Fault History").set("Fields", Teuchos::Array<std::string>(slip_twice));
  EXPECT_TRUE(test::contains(error(twice), "for the fault names 'slip' twice")) << error(twice);
  body.locations.erase("surface");
  EXPECT_TRUE(test::contains(error(ParameterList()), "this problem has no surface"));
}
