#include "scenario/setup/rock/RockSetup.hpp"

#include "SampleDeck.hpp"
#include "hdf5/File.hpp"
#include "scenario/setup/rock/BulkSetup.hpp"
#include "unit/base/TemporaryDirectory.hpp"

#include <cmath>

namespace asperity::scenario
{
using namespace test;

namespace
{
constexpr double shear = 1e6;                                                 // Pa
constexpr double bulk = 2.5e6;                                                // Pa
constexpr double poisson = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)); // of both

// The list `Bulk` of a deck that gives these elastic constants alone, then changed.
ParameterList bulkList(
  std::vector<std::pair<char const*, double>> const& constants,
  std::function<void(ParameterList&)> const& change = [](auto&) {})
{
  return completeDeck([&](ParameterList& deck) {
           auto& list = deck.sublist("Bulk");
           list.remove("Shear Modulus");
           list.remove("Bulk Modulus");
           for (auto const& [name, value] : constants) {
             list.set(name, value);
           }
           change(list);
         })
    .sublist("Bulk");
}

Rock rockOf(ParameterList const& list, Mesh<2> const& mesh)
{
  return makeRock(BulkSettings::from(list), list, mesh, *world());
}

std::vector<fem::Material> makeMaterials(ParameterList const& list, Mesh<2> const& mesh)
{
  return rockOf(list, mesh).materials;
}

void beAntiplane(ParameterList& list)
{
  list.set("Model", "Antiplane").set("Gravitational Acceleration", 0.);
}
} // namespace

TEST(RockSetup, FindsTheModuliFromAnyTwo)
{
  const auto mesh = twoRegions();
  using Constants = std::vector<std::pair<char const*, double>>;
  for (auto const& constants :
       {Constants{{"Bulk Modulus", bulk}, {"Shear Modulus", shear}},
        Constants{{"Bulk Modulus", bulk}, {"Poisson's Ratio", poisson}},
        Constants{{"Shear Modulus", shear}, {"Poisson's Ratio", poisson}}}) {
    const auto materials = makeMaterials(bulkList(constants), mesh);
    ASSERT_EQ(materials.size(), mesh.cells.size());
    for (auto const& material : materials) {
      EXPECT_NEAR(material.bulk_modulus, bulk, 1e-9 * bulk);
      EXPECT_NEAR(material.shear_modulus, shear, 1e-9 * shear);
      EXPECT_EQ(material.density, 1000);
      EXPECT_EQ(material.shear_viscosity, 0);
    }
  }
}

TEST(RockSetup, WantsExactlyTwoModuli)
{
  const auto mesh = twoRegions();
  const auto message = [&mesh](auto const& constants) {
    return refusal([&] { makeMaterials(bulkList(constants), mesh); });
  };
  using Constants = std::vector<std::pair<char const*, double>>;
  expectParts(message(Constants{}), {"Asperity / Bulk", "0 of", "exactly two"});
  expectParts(message(Constants{{"Shear Modulus", shear}}), {"Asperity / Bulk", "1 of"});
  expectParts(message(Constants{
                {"Shear Modulus", shear}, {"Bulk Modulus", bulk}, {"Poisson's Ratio", poisson}}),
              {"3 of", "'Poisson's Ratio'"});
}

TEST(RockSetup, NeedsTheShearModulusAloneInAntiplane)
{
  const auto mesh = twoRegions();
  const auto alone = bulkList({{"Shear Modulus", shear}}, beAntiplane);
  EXPECT_EQ(BulkSettings::from(alone).components, 1);
  EXPECT_EQ(makeMaterials(alone, mesh).front().shear_modulus, shear);
  const auto others = bulkList({{"Bulk Modulus", bulk}, {"Poisson's Ratio", poisson}}, beAntiplane);
  EXPECT_NEAR(makeMaterials(others, mesh).front().shear_modulus, shear, 1e-9 * shear);
  expectRefusal(
    [&] {
      makeMaterials(bulkList({{"Bulk Modulus", bulk}}, beAntiplane), mesh);
    },
    {"Asperity / Bulk", "1 of", "or the shear modulus alone"});
}

TEST(RockSetup, FindsTheModuliFromWaveSpeeds)
{
  const auto mesh = twoRegions();
  const double rho = 1000, cs = std::sqrt(shear / rho),
               cp = std::sqrt((bulk + 4. / 3 * shear) / rho);
  for (auto const& material :
       makeMaterials(bulkList({{"P-Wave Speed", cp}, {"S-Wave Speed", cs}}), mesh)) {
    EXPECT_NEAR(material.bulk_modulus, bulk, 1e-9 * bulk);
    EXPECT_NEAR(material.shear_modulus, shear, 1e-9 * shear);
    EXPECT_EQ(material.density, rho);
  }
  const auto antiplane = bulkList({{"S-Wave Speed", cs}}, beAntiplane);
  EXPECT_NEAR(makeMaterials(antiplane, mesh).front().shear_modulus, shear, 1e-9 * shear);
}

TEST(RockSetup, RefusesWaveSpeedsThatGiveNoModuli)
{
  const auto mesh = twoRegions();
  const auto message = [&mesh](auto const& constants) {
    return refusal([&] { makeMaterials(bulkList(constants), mesh); });
  };
  using Constants = std::vector<std::pair<char const*, double>>;
  expectParts(message(Constants{{"S-Wave Speed", 30}}),
              {"Asperity / Bulk / P-Wave Speed is missing"});
  expectParts(message(Constants{{"P-Wave Speed", 60}}),
              {"Asperity / Bulk / S-Wave Speed is missing"});
  expectParts(
    message(Constants{{"P-Wave Speed", 60}, {"S-Wave Speed", 30}, {"Shear Modulus", 1e6}}),
    {"Asperity / Bulk / P-Wave Speed is given beside a modulus", "not both"});
  expectParts(message(Constants{{"P-Wave Speed", 34}, {"S-Wave Speed", 30}}),
              {"P-Wave Speed is 34 m/s at (x, y, z) = (", "S-Wave Speed is 30 m/s", "1.155"});
}

// Means over the vertices of a field that is linear in place are its values at the centroids.
TEST(RockSetup, TakesMeansOfADatasetOverTheVerticesOfACell)
{
  const auto mesh = twoRegions();
  std::vector<double> values(mesh.num_global_vertices);
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    auto const& x = mesh.vertices[vertex];
    values[mesh.global_ids[vertex]] = shear * (1 + 0.1 * x[0] - 0.05 * x[1]);
  }
  const asperity::test::TemporaryDirectory directory;
  auto file = h5::File::create(directory.file("rock.h5"));
  file.store("G", values.data(), {values.size()});
  file.close();
  const std::string name = directory.file("rock.h5") + ":/G";
  const auto given = [&](char const* parameter) {
    return makeMaterials(bulkList({{"Bulk Modulus", bulk}, {"Shear Modulus", shear}},
                                  [&](ParameterList& list) {
                                    list.remove(parameter, false);
                                    list.set(parameter, name);
                                  }),
                         mesh);
  };
  auto const by_modulus = given("Shear Modulus"), by_density = given("Density");
  auto const by_viscosity = given("Shear Viscosity");
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    double expected = 0;
    for (const int vertex : mesh.cells[cell]) {
      auto const& x = mesh.vertices[vertex];
      expected += shear * (1 + 0.1 * x[0] - 0.05 * x[1]) / 3;
    }
    EXPECT_NEAR(by_modulus[cell].shear_modulus, expected, 1e-12 * shear);
    EXPECT_NEAR(by_density[cell].density, expected, 1e-12 * shear);
    EXPECT_NEAR(by_viscosity[cell].shear_viscosity, expected, 1e-12 * shear);
  }
}

TEST(RockSetup, EvaluatesFieldsByRegionAndPlace)
{
  const auto mesh = twoRegions();
  const auto list =
    bulkList({{"Bulk Modulus", bulk}, {"Shear Modulus", shear}}, [](ParameterList& given) {
      given.remove("Density");
      given.sublist("Density").set("left", 900.).set("right", 1100.);
      given.set("Bulk Viscosity", "1 + x");
    });
  const auto materials = makeMaterials(list, mesh);
  for (std::size_t cell = 0; cell < materials.size(); ++cell) {
    double x = 0;
    for (int vertex : mesh.cells[cell]) {
      x += mesh.vertices[vertex][0] / 3;
    }
    EXPECT_EQ(materials[cell].density, x < 1 ? 900 : 1100);
    EXPECT_NEAR(materials[cell].bulk_viscosity, 1 + x, 1e-14);
  }
}

// The modulus of the shares, and 1 / G(p) of a Maxwell and a Kelvin element one after the other.
TEST(RockSetup, RelaxesAsTheElementsOfBurgers)
{
  const auto mesh = twoRegions();
  const auto list =
    bulkList({{"Bulk Modulus", bulk}, {"Shear Modulus", shear}}, [](ParameterList& given) {
      given.set("Law", "Burgers").set("Viscosity", "x < 1 ? 3e6 : 1e9");
      given.set("Transient Viscosity", 2e5).set("Transient Shear Modulus", 4e6);
    });
  const auto rock = rockOf(list, mesh);
  ASSERT_EQ(rock.branches.size(), 4u);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const double viscosity = mesh.region_names[mesh.cell_regions[cell]] == "left" ? 3e6 : 1e9;
    for (const double p : {1e-6, 1e-2, 1., 30., 1e4}) {
      double modulus = 0;
      for (auto const& branch : rock.branches) {
        modulus += branch.moduli[cell] * p / (p + 1 / branch.time);
      }
      const double expected = 1 / (1 / shear + 1 / (viscosity * p) + 1 / (4e6 + 2e5 * p));
      EXPECT_NEAR(modulus, expected, 1e-12 * expected) << p;
    }
  }
}

TEST(RockSetup, GivesRegionsLawsOfTheirOwn)
{
  const auto mesh = twoRegions();
  const auto list =
    bulkList({{"Bulk Modulus", bulk}, {"Shear Modulus", shear}}, [](ParameterList& given) {
      given.set("Shear Viscosity", 7.);
      given.sublist("Regions").sublist("right").set("Law", "Maxwell").set("Viscosity", 5e6);
    });
  const auto rock = rockOf(list, mesh);
  ASSERT_EQ(rock.branches.size(), 1u);
  EXPECT_NEAR(rock.branches[0].time, 5, 1e-14);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const bool flows = mesh.region_names[mesh.cell_regions[cell]] == "right";
    EXPECT_EQ(rock.branches[0].moduli[cell], flows ? shear : 0);
    EXPECT_EQ(rock.materials[cell].shear_viscosity, flows ? 0 : 7);
  }
}

TEST(RockSetup, AsksALawForValuesInItsOwnRegionsAlone)
{
  const auto mesh = twoRegions();
  const auto rock = [&mesh](char const* of_main_law) {
    return rockOf(bulkList({{"Bulk Modulus", bulk}, {"Shear Modulus", shear}},
                           [&](ParameterList& given) {
                             given.remove("Shear Viscosity", false);
                             given.sublist("Shear Viscosity").set(of_main_law, 7.);
                             auto& own = given.sublist("Regions").sublist("right");
                             own.set("Law", "Maxwell");
                             own.sublist("Viscosity").set("right", 5e6);
                           }),
                  mesh);
  };
  const auto found = rock("left");
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const bool flows = mesh.region_names[mesh.cell_regions[cell]] == "right";
    EXPECT_EQ(found.branches.at(0).moduli[cell], flows ? shear : 0);
    EXPECT_EQ(found.materials[cell].shear_viscosity, flows ? 0 : 7);
  }
  expectRefusal([&] { rock("right"); },
                {"Asperity / Bulk / Shear Viscosity has no value for the region 'left'"});
}

TEST(RockSetup, RefusesLawsOfRegionsThatDoNotExistOrFlowBackwards)
{
  const auto mesh = twoRegions();
  const auto make = [&mesh](char const* region, double viscosity) {
    rockOf(bulkList({{"Bulk Modulus", bulk}, {"Shear Modulus", shear}},
                    [&](ParameterList& given) {
                      auto& own = given.sublist("Regions").sublist(region);
                      own.set("Law", "Maxwell").set("Viscosity", viscosity);
                    }),
           mesh);
  };
  expectRefusal([&] { make("rigt", 1e6); },
                {"Asperity / Bulk / Regions / rigt: 'rigt' is not a region of the mesh.", "'right'",
                 "A layer that is thinner than the cells"});
  expectRefusal([&] { make("right", -1e6); },
                {"Asperity / Bulk / Regions / right / Viscosity", "outside (0, inf)"});
}

TEST(RockSetup, RefusesFieldsThatLeaveTheirRangeSomewhere)
{
  const auto mesh = twoRegions();
  const auto list = bulkList({{"Bulk Modulus", bulk}, {"Shear Modulus", shear}},
                             [](ParameterList& given) { given.set("Density", "1.5 - x"); });
  expectRefusal([&] { makeMaterials(list, mesh); },
                {"Asperity / Bulk / Density", "outside (0, inf)", "x"});
}
} // namespace asperity::scenario
