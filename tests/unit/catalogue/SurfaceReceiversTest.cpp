#include "catalogue/receivers/Receivers.hpp"
#include "unit/io/VerticalFault.hpp"

using namespace asperity;
using namespace asperity::catalogue;
using namespace asperity::io;
using test::position;

namespace
{
ParameterList complete(ParameterList list)
{
  completeAndValidate(list, *Receivers::validParameters(), "Asperity / Output / Receivers");
  return list;
}

ParameterList parameters()
{
  ParameterList list;
  list.sublist("On Fault").set("st12dp07", position({0., -0.7, 1.2}));
  list.sublist("Off Fault").set("inside", position({0.3, -2.1, 0.4}));
  return list;
}

void run(std::filesystem::path const& directory, ParameterList const& list, bool periodic = false)
{
  test::VerticalFault fault(periodic);
  Receivers receivers(complete(list), fault.context(directory));
  receivers.write(fault.at(0, 1));
  receivers.write(fault.at(1, 1, true));
  receivers.closeSegment(0);
}
} // namespace

TEST(SurfaceReceivers, VectorsAreInterpolatedInTrianglesAndTetrahedra)
{
  test::TemporaryDirectory directory;
  run(directory.path(), parameters());
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "receivers.h5");
    const auto slip = file.openDataset("on_fault/fields/slip");
    ASSERT_EQ(slip.shape(), (h5::Shape{2, 1, 3}));
    EXPECT_NEAR(slip.read<double>()[1], 1.9, 1e-14);
    EXPECT_NEAR(slip.read<double>()[2], 3.8, 1e-14);
    const auto displacement = file.openDataset("off_fault/fields/displacement").read<double>();
    EXPECT_NEAR(displacement[0], 0.3, 1e-14);
    EXPECT_NEAR(displacement[1], -2.1, 1e-14);
    EXPECT_NEAR(displacement[2], 0.4, 1e-14);
    EXPECT_FALSE(file.has("on_fault/positions"));
  });
}

TEST(SurfaceReceivers, ThoseOutsideAreRefusedByName)
{
  test::TemporaryDirectory directory;
  auto list = parameters();
  list.sublist("On Fault").set("st50", position({0., -0.7, 5.}));
  const auto outside = test::refusal([&] { run(directory.path(), list); });
  test::expectParts(outside, {"On Fault / st50 = (0, -0.7, 5) is 2 m outside of the fault, "
                              "whose coordinates go from (0, -4, 0) to (0, 0, 3) m"});
  list = parameters();
  list.sublist("Off Fault").set("above", position({0.5, 0.25, 1.}));
  test::expectRefusal([&] { run(directory.path(), list); },
                      {"above = (0.5, 0.25, 1) is 0.25 m outside of the mesh"});
  list = parameters();
  list.sublist("On Fault").set("flat", position({0., -1.}));
  test::expectRefusal([&] { run(directory.path(), list); },
                      {"flat has 2 coordinates; a position in this mesh has 3"});
}

TEST(SurfaceReceivers, CellsAcrossAPeriodAreFound)
{
  test::TemporaryDirectory directory;
  auto list = parameters();
  list.sublist("On Fault").set("st26", position({0., -0.5, 2.6}));
  list.sublist("Off Fault").set("deep", position({0.5, -0.5, 2.9}));
  run(directory.path(), list, true);
  test::onRankZero([&] {
    const auto file = h5::File::open(directory / "receivers.h5");
    const auto on_fault = file.openDataset("on_fault/coordinates").read<double>();
    EXPECT_NEAR(on_fault[5], 2.6, 1e-14);
    // Between z = 2 and z = 3, where the nodes are those of z = 0: the field is not linear there.
    const auto slip = file.openDataset("on_fault/fields/slip").read<double>();
    EXPECT_NEAR(slip[4], 0.5 + 0.4 * 2 + 0.6 * 0, 1e-14);
    EXPECT_NEAR(file.openDataset("off_fault/coordinates").read<double>()[5], 2.9, 1e-14);
  });
}
