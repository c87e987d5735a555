#include "scenario/setup/rock/BulkSetup.hpp"

#include "SampleDeck.hpp"

namespace asperity::scenario
{
using namespace test;

namespace
{
constexpr double bulk = 2.5e6; // Pa

// The list `Bulk` of a complete deck, changed.
ParameterList bulkList(std::function<void(ParameterList&)> const& change = [](auto&) {})
{
  return completeDeck([&](ParameterList& deck) { change(deck.sublist("Bulk")); }).sublist("Bulk");
}
} // namespace

TEST(BulkSetup, PointsGravityAnyWay)
{
  const auto list = bulkList([](ParameterList& given) {
    given.set("Gravity Direction", array<double>({3, -4}));
  });
  EXPECT_NEAR(gravity<2>(BulkSettings::from(list))[0], 6, 1e-14);
  EXPECT_NEAR(gravity<2>(BulkSettings::from(list))[1], -8, 1e-14);
  EXPECT_EQ(gravity<2>(BulkSettings::from(bulkList())), (std::array<double, 2>{0, -10}));
}

TEST(BulkSetup, RefusesGravityThatMakesNoSense)
{
  for (auto const& direction : {std::vector<double>{0, 0}, {1}, {1, 2, 3}, {}}) {
    const auto list =
      bulkList([&](ParameterList& given) { given.set("Gravity Direction", array(direction)); });
    expectRefusal([&] { gravity<2>(BulkSettings::from(list)); },
                  {"Asperity / Bulk / Gravity Direction"});
  }
  const auto antiplane = bulkList([](ParameterList& given) { given.set("Model", "Antiplane"); });
  expectRefusal([&] { gravity<2>(BulkSettings::from(antiplane)); },
                {"Asperity / Bulk / Gravitational Acceleration = 10", "antiplane"});
}

TEST(BulkSetup, DampsAQuasiDynamicFaultByTheImpedanceOfItsSides)
{
  const auto mesh = twoRegions();
  const FieldNodes nodes(mesh, {0, 1});
  const std::vector<fem::Material> materials = {{1000, bulk, 4e6, 0, 0}, {4000, bulk, 1e6, 0, 0}};
  const auto damping = [&](fem::OtherSide side, std::function<void(ParameterList&)> const& change) {
    const auto list = bulkList(change);
    return radiationDamping(BulkSettings::from(list), list, nodes, side, materials);
  };
  const auto quasi = [](ParameterList& list) { list.set("Dynamics", "Quasi-dynamic"); };
  EXPECT_FALSE(BulkSettings::from(bulkList()).isQuasiDynamic());
  EXPECT_TRUE(BulkSettings::from(bulkList(quasi)).isQuasiDynamic());
  EXPECT_EQ(damping(fem::OtherSide::rigid_foundation, [](auto&) {}), (std::vector<double>{0, 0}));
  // G / cs = sqrt(rho G), half of it from each side.
  const double impedance = std::sqrt(4e9);
  EXPECT_NEAR(damping(fem::OtherSide::rigid_foundation, quasi)[0], impedance, 1e-9 * impedance);
  EXPECT_NEAR(damping(fem::OtherSide::mirror_image, quasi)[0], impedance / 2, 1e-9 * impedance);
  EXPECT_NEAR(damping(fem::OtherSide::mirror_image, quasi)[1], impedance / 2, 1e-9 * impedance);
  const auto given = damping(fem::OtherSide::mirror_image, [&](ParameterList& list) {
    quasi(list);
    list.sublist("Quasi-dynamic").set("Radiation Damping", "5 + x");
  });
  EXPECT_EQ(given, (std::vector<double>{5 + mesh.vertices[0][0], 5 + mesh.vertices[1][0]}));
}
} // namespace asperity::scenario
