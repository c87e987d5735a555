#include "io/TextFormat.hpp"
#include "parameters/Parameters.hpp"
#include "unit/io/Body.hpp"

// All outputs of a run with the files for the platforms.
using namespace asperity;
using namespace asperity::io;
using test::Body;
using test::num_steps;
using test::world;

namespace
{
namespace fs = std::filesystem;
using Names = std::vector<std::string>;

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
} // namespace

TEST(Registries, HoldAllOutputsAndTextFormats)
{
  EXPECT_EQ(OutputRegistry::instance().names(),
            (Names{"Event Catalogue", "Fault History", "Global", "Receivers", "Rupture",
                   "Step Table", "Surface History", "Volume Snapshots"}));
  EXPECT_EQ(TextFormatRegistry::instance().names(), (Names{"SCEC", "SEAS"}));
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
      const auto expected = test::readNumbers(whole / file, name);
      EXPECT_EQ(test::readNumbers(broken / file, name), expected) << file << " " << name;
      EXPECT_FALSE(expected.empty()) << file << " " << name;
    }
  }
}

void expectRestartsExactly(std::string const& text_format, Names const& more_texts)
{
  test::TemporaryDirectory whole, broken;
  {
    Body body;
    OutputSet outputs(deck(text_format), {whole.path(), world(), body.fields, body.domains});
    test::steps(outputs, body, whole.path(), 0, num_steps + 1);
    test::finish(outputs, whole.path());
    EXPECT_EQ(outputs.numEvents(), 3);
    test::expectParts(outputs.report(), {"\n3 events\n"});
  }
  {
    Body body;
    OutputSet outputs(deck(text_format), {broken.path(), world(), body.fields, body.domains});
    test::steps(outputs, body, broken.path(), 0,
                40); // checkpoint after step 24, killed after step 39
  }
  {
    Body body;
    OutputSet outputs(deck(text_format), {broken.path(), world(), body.fields, body.domains});
    const Archive archive =
      readCheckpoint(broken / "checkpoint.h5", Fingerprint{{{"Asperity", "deck", ""}}}, *world());
    outputs.restore(archive.child("outputs"));
    test::steps(outputs, body, broken.path(), 25, num_steps + 1);
    test::finish(outputs, broken.path());
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
  expectRestartsExactly("SEAS", {"seas/fltst_dp001", "seas/srfst_inside", "seas/global.dat",
                                 "seas/rupture.dat", "seas/slip.dat"});
  expectRestartsExactly("SCEC", {"scec/faultdp001", "scec/bodyinside", "scec/cplot"});
}

TEST(OutputSet, ALongRunHasTooManyRowsOfEqualTimes)
{
  test::TemporaryDirectory directory;
  Body body;
  const auto make = [&](double final_time) {
    const OutputContext context{directory.path(), world(),   body.fields,
                                body.domains,     {0, 1, 0}, final_time};
    const OutputSet outputs(deck("SCEC"), context);
  };
  make(1e5); // 0.01 s apart
  test::expectRefusal([&] { make(1.001e5); }, {"SCEC / Time Step", "1.001e+07 rows", "SEAS"});
}

TEST(OutputSet, ARestartForAnotherPlatformIsRefused)
{
  test::TemporaryDirectory directory;
  Body body;
  const OutputContext context{directory.path(), world(), body.fields, body.domains};
  for (auto const& [earlier, now] :
       {std::pair("None", "SEAS"), std::pair("SCEC", "SEAS"), std::pair("SEAS", "None")}) {
    const Archive archive = OutputSet(deck(earlier), context).save();
    OutputSet after(deck(now), context);
    test::expectRefusal(
      [&] { after.restore(archive); },
      {std::string("Text Format is ") + now + ", but it was " + earlier + " in the run"});
  }
}
