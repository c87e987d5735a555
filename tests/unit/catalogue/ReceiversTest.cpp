#include "catalogue/receivers/Receivers.hpp"
#include "unit/io/LinearFault.hpp"

using namespace asperity;
using namespace asperity::catalogue;
using namespace asperity::io;
using Fault = test::LinearFault;
using test::position;

namespace
{
constexpr double step_size = 0.4;

ParameterList parameters()
{
  ParameterList list;
  list.sublist("On Fault").set("dp003", position({0.3, 0.}));
  list.sublist("On Fault").set("dp000", position({0., 0.}));
  list.sublist("Off Fault").set("inside", position({0.5, 0.75}));
  return list;
}

ParameterList complete(ParameterList list)
{
  completeAndValidate(list, *Receivers::validParameters(), "Asperity / Output / Receivers");
  return list;
}

// Steps 0 to 4, a segment closed after step 2 and at the end.
void run(Fault& fault, Receivers& receivers)
{
  for (int step = 0; step <= 4; ++step) {
    receivers.write(fault.at(step, step_size, step == 4));
    if (step == 2) {
      receivers.closeSegment(0);
    }
  }
  receivers.closeSegment(1);
}

// Above the strip the ground rises from y = 1 to y = 1.2.
Mesh<2> hill()
{
  auto mesh = test::stripMesh(6);
  for (auto& vertex : mesh.vertices) {
    vertex[1] *= 1 + 0.2 * vertex[0];
  }
  return mesh;
}

struct FaultBelowHill : Fault
{
  FaultBelowHill() : Fault(2, hill())
  {
    domains["surface"] =
      boundaryDomain("surface", hill(), "surface", test::world(), CurveStart::smaller_x);
  }
};

// The message with which receivers are refused that the ground or the list makes impossible.
template <class Model>
std::string refusalOn(ParameterList const& list)
{
  test::TemporaryDirectory directory;
  Model model;
  return test::refusal([&] { Receivers(complete(list), model.context(directory.path())); });
}

std::string refusal(ParameterList const& list)
{
  test::TemporaryDirectory directory;
  Fault fault;
  return test::refusal([&] { Receivers(complete(list), fault.context(directory.path())); });
}
} // namespace

TEST(Receivers, WriteSeriesOfInterpolatedFields)
{
  test::TemporaryDirectory directory;
  Fault fault;
  Receivers receivers(complete(parameters()), fault.context(directory.path()));
  run(fault, receivers);
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "receivers.h5");
    EXPECT_EQ(file.textAttribute("format"), "asperity receivers");
    EXPECT_EQ(file.openDataset("on_fault/names").readTexts(),
              (std::vector<std::string>{"dp003", "dp000"}));
    EXPECT_EQ(file.openDataset("off_fault/coordinates").read<double>(),
              (std::vector<double>{0.5, 0.75}));
    EXPECT_NEAR(file.openDataset("on_fault/positions").read<double>()[0], 0.3, 1e-15);
    EXPECT_EQ(file.openDataset("on_fault/positions").textAttribute("description"),
              "Distance along the fault from its upper end (greater y; of ends equally high the "
              "one with smaller x).");
    const auto slip = file.openDataset("on_fault/fields/slip");
    const auto displacement = file.openDataset("off_fault/fields/displacement");
    ASSERT_EQ(slip.shape(), (h5::Shape{5, 2}));
    ASSERT_EQ(displacement.shape(), (h5::Shape{5, 1, 2}));
    EXPECT_TRUE(receivers.notes().empty()); // none is moved
    EXPECT_EQ(file.openDataset("step").read<std::int64_t>(),
              (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
    for (int step = 0; step <= 4; ++step) {
      const double time = step * step_size;
      EXPECT_NEAR(slip.read<double>()[2 * step], 0.3 * time, 1e-15);
      EXPECT_EQ(slip.read<double>()[2 * step + 1], 0);
      EXPECT_NEAR(displacement.read<double>()[2 * step], 2 + time, 1e-14);
      EXPECT_NEAR(displacement.read<double>()[2 * step + 1], 4 + time, 1e-14);
    }
  });
}

TEST(Receivers, FieldsThatTheFaultHasAreWrittenWithoutBeingNamed)
{
  test::TemporaryDirectory directory;
  Fault fault;
  for (auto const* name :
       {"slip_velocity", "opening", "pore_pressure", "temperature", "psi", "other"}) {
    fault.add("fault", name, 1, [](double const*, int) { return 3; });
  }
  Receivers receivers(complete(parameters()), fault.context(directory.path()));
  run(fault, receivers);
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "receivers.h5");
    for (auto const* name : {"slip_velocity", "opening", "pore_pressure", "temperature", "theta"}) {
      EXPECT_TRUE(file.has(std::string("on_fault/fields/") + name)) << name;
    }
    for (auto const* name : {"psi", "other", "darcy_velocity"}) { // psi: theta is the state
      EXPECT_FALSE(file.has(std::string("on_fault/fields/") + name)) << name;
    }
  });
}

TEST(Receivers, ANumberIsADistanceAlongTheFault)
{
  test::TemporaryDirectory directory;
  Fault fault;
  auto list = parameters();
  list.sublist("On Fault").set("dp003", position({0.3}));
  Receivers receivers(complete(list), fault.context(directory.path()));
  run(fault, receivers);
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "receivers.h5");
    const auto places = file.openDataset("on_fault/coordinates").read<double>();
    EXPECT_NEAR(places[0], 0.3, 1e-15);
    EXPECT_NEAR(places[1], 0, 1e-15);
  });
  list.sublist("On Fault").set("dp003", position({1.5}));
  const auto message = refusal(list);
  test::expectParts(message, {"On Fault / dp003: the fault is not as long as 1.5 m; its "
                              "coordinates go from (0, 0) to (1, 0) m"});
}

TEST(Receivers, WithoutAnyNothingIsWritten)
{
  test::TemporaryDirectory directory;
  Fault fault;
  Receivers receivers(complete({}), fault.context(directory.path()));
  run(fault, receivers);
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(Receivers, ThoseBesideTheFaultOrOutsideOfTheMeshAreRefusedByName)
{
  auto list = parameters();
  list.sublist("On Fault").set("st8", position({0.5, 0.25}));
  const auto beside = refusal(list);
  test::expectParts(beside, {"Receivers / On Fault / st8 = (0.5, 0.25) is 0.25 m outside "
                             "of the fault, whose coordinates go from (0, 0) to (1, 0) m"});
  list = parameters();
  list.sublist("Off Fault").set("far", position({3., 0.5}));
  const auto outside = refusal(list);
  test::expectParts(outside, {"Receivers / Off Fault / far = (3, 0.5) is 2 m outside of "
                              "the mesh, whose coordinates go from (0, 0) to (1, 1) m"});
  list = parameters();
  list.sublist("Off Fault").set("flat", position({3}));
  test::expectParts(refusal(list), {"flat has 1 coordinates"});
}

TEST(Receivers, ThoseOnTheGroundAreMovedThere)
{
  test::TemporaryDirectory directory;
  FaultBelowHill model;
  auto list = parameters();
  list.sublist("On Ground").set("above", position({0.3, 1.2}));
  list.sublist("On Ground").set("without", position({0.5}));
  list.sublist("On Ground").set("at", position({0., 1.}));
  Receivers receivers(complete(list), model.context(directory.path()));
  receivers.write(model.at(0, step_size, true));
  receivers.closeSegment(0);
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "receivers.h5");
    EXPECT_EQ(file.openDataset("off_fault/names").readTexts(),
              (std::vector<std::string>{"inside", "above", "without", "at"}));
    const auto places = file.openDataset("off_fault/coordinates").read<double>();
    const std::vector<double> expected = {0.5, 0.75, 0.3, 1.06, 0.5, 1.1, 0, 1};
    ASSERT_EQ(places.size(), expected.size());
    const auto displacement = file.openDataset("off_fault/fields/displacement").read<double>();
    for (std::size_t i = 0; i < expected.size(); i += 2) {
      EXPECT_NEAR(places[i], expected[i], 1e-14);
      EXPECT_NEAR(places[i + 1], expected[i + 1], 1e-14);
      EXPECT_NEAR(displacement[i], expected[i] + 2 * expected[i + 1], 1e-14);
    }
  });
  auto const notes = receivers.notes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0], "Receivers on the ground: 'above' at (0.3, 1.06) m, 0.14 m below the given "
                      "place, 'without' at (0.5, 1.1) m, 'at' at (0, 1) m.");
  EXPECT_TRUE(receivers.warnings().empty());
}

TEST(Receivers, AHeightFarFromTheGroundIsAWarning)
{
  test::TemporaryDirectory directory;
  FaultBelowHill model;
  ParameterList list;
  list.sublist("On Ground").set("near", position({0.3, 1.}));
  list.sublist("On Ground").set("low", position({0.3, 0.}));
  const Receivers receivers(complete(list), model.context(directory.path()));
  auto const warnings = receivers.warnings();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].topic, "receivers far from the ground");
  test::expectParts(warnings[0].text, {"Receivers / On Ground", "'low' by 1.06 m, where"});
  EXPECT_EQ(warnings[0].text.find("near"), std::string::npos);
}

TEST(Receivers, PlacesThatCannotBeOnTheGroundAreRefused)
{
  const auto on_ground = [](std::vector<double> const& place) {
    auto list = parameters();
    list.sublist("On Ground").set("gps", position(place));
    return list;
  };
  test::expectParts(refusalOn<FaultBelowHill>(on_ground({1.5, 1})),
                    {"Receivers / On Ground / gps = (1.5, 1) has no ground above or below it"});
  test::expectParts(refusalOn<FaultBelowHill>(on_ground({0.5, 1, 2})),
                    {"gps has 3 coordinates; a position in this mesh has 2, or 1 without y"});
  test::expectParts(refusal(on_ground({0.5, 1})),
                    {"Receivers / On Ground / gps: the model has no ground", "Free Surface"});
  auto twice = parameters();
  twice.sublist("On Ground").set("inside", position({0.5}));
  test::expectParts(refusalOn<FaultBelowHill>(twice),
                    {"On Ground / inside: a receiver of this name is in Off Fault"});
}

TEST(Receivers, ThoseAboveTheGroundAreToldItsHeight)
{
  auto list = parameters();
  list.sublist("Off Fault").set("gps", position({0.5, 1.2}));
  test::expectParts(refusalOn<FaultBelowHill>(list),
                    {"Off Fault / gps = (0.5, 1.2) is ", " m outside of the mesh",
                     "The free surface there is at (0.5, 1.1) m, 0.1 m below it; the list On "
                     "Ground moves receivers there."});
  EXPECT_EQ(refusal(list).find("free surface"), std::string::npos); // the model has none
}

TEST(Receivers, RoundedPositionsOnTheFaultAreProjected)
{
  test::TemporaryDirectory directory;
  Fault fault;
  ParameterList list;
  list.sublist("On Fault").set("near", position({0.5, -0.0027})); // the facet has 0.28 m
  Receivers receivers(complete(list), fault.context(directory.path()));
  run(fault, receivers);
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "receivers.h5");
    EXPECT_NEAR(file.openDataset("on_fault/coordinates").read<double>()[1], 0, 1e-15);
    EXPECT_FALSE(file.has("off_fault"));
  });
  EXPECT_EQ(receivers.notes(),
            (std::vector<std::string>{"Receivers that lie outside of the fault are moved to it: "
                                      "'near' by 0.0027 m to (0.5, 0) m."}));
}

TEST(Receivers, NamesThatNoFileCanHaveAreRefused)
{
  for (std::string const name : {"st/025", ""}) {
    ParameterList list;
    list.sublist("On Fault").set(name, position({0.3, 0.}));
    const auto message = refusal(list);
    test::expectParts(message, {"On Fault: a receiver cannot be called '" + name + "'"});
  }
}

TEST(Receivers, FieldsNamedTwiceAreRefused)
{
  auto list = parameters();
  list.set("Fault Fields",
           Teuchos::Array<std::string>(std::vector<std::string>{"slip", "theta", "slip"}));
  test::expectParts(refusal(list), {"Receivers / Fault Fields names 'slip' twice"});
}

TEST(Receivers, ARestartWithOthersIsRefused)
{
  test::TemporaryDirectory directory;
  Fault fault;
  Archive archive;
  Receivers before(complete(parameters()), fault.context(directory.path()));
  run(fault, before);
  before.save(archive);
  auto list = parameters();
  list.sublist("On Fault").set("dp005", position({0.5, 0.}));
  Receivers after(complete(list), fault.context(directory.path()));
  test::expectRefusal([&] { after.restore(archive); },
                      {"Receivers: the checkpoint continues files with other receivers"});
}
