#include "scenario/setup/BoundarySetup.hpp"

#include "SampleDeck.hpp"

namespace asperity::scenario
{
using namespace test;

namespace
{
struct Condition
{
  std::string name, boundary, type;
};

// Friction on the bottom comes with them unless they bring it.
ParameterList conditions(std::vector<Condition> const& given, bool with_fault = true)
{
  return completeDeck([&](ParameterList& deck) {
           deck.remove("Boundary Conditions");
           auto& list = deck.sublist("Boundary Conditions");
           for (auto const& [name, boundary, type] : given) {
             list.sublist(name).set("Boundary", boundary).set("Type", type);
           }
           if (with_fault) {
             list.sublist("Fault").set("Boundary", "bottom").set("Type", "Bilateral Contact");
           }
         })
    .sublist("Boundary Conditions");
}

ParameterList driven(std::function<void(ParameterList&)> const& change)
{
  return completeDeck([&](ParameterList& deck) {
           auto& condition = deck.sublist("Boundary Conditions").sublist("Left");
           condition.set("Type", "Prescribed Velocity");
           change(condition);
         })
    .sublist("Boundary Conditions");
}
} // namespace

TEST(BoundarySetup, turnsConditionsIntoPrescribedVelocities)
{
  const auto result = makeBoundaryConditions<2>(conditions({{"Wall", "right", "Sliding Wall"},
                                                            {"Ground", "left", "Fixed"},
                                                            {"Air", "top", "Free Surface"}}),
                                                2);
  EXPECT_EQ(result.fault, "bottom");
  EXPECT_EQ(result.surface, "top");
  EXPECT_EQ(result.ramp_end, 0);
  ASSERT_EQ(result.velocities.size(), 4U);
  // The contact of the fault is the first, so that frames follow it.
  EXPECT_EQ(result.velocities[0].boundary, "bottom");
  EXPECT_TRUE(result.velocities[0].direction.empty()) << "along the normal";
  std::vector<std::vector<double>> fixed;
  for (auto const& velocity : result.velocities) {
    EXPECT_FALSE(velocity.velocity) << "at rest";
    if (velocity.boundary == "left") {
      fixed.push_back(velocity.direction);
    }
  }
  EXPECT_EQ(fixed, (std::vector<std::vector<double>>{{1, 0}, {0, 1}}));
}

TEST(BoundarySetup, hasNoNormalInAntiplane)
{
  const auto result = makeBoundaryConditions<2>(
    conditions({{"Wall", "right", "Sliding Wall"}, {"Ground", "left", "Fixed"}}), 1);
  ASSERT_EQ(result.velocities.size(), 1U);
  EXPECT_EQ(result.velocities[0].boundary, "left");
  EXPECT_EQ(result.velocities[0].direction, std::vector<double>{1});
}

TEST(BoundarySetup, prescribesAVelocityWithARamp)
{
  const auto result =
    makeBoundaryConditions<2>(driven([](ParameterList& condition) {
                                condition.set("Velocity", "2 * (1 + x) * (1 + t)");
                                condition.set("Ramp Duration", 4.);
                                condition.set("Direction", array<double>({0, 2}));
                              }),
                              2);
  EXPECT_EQ(result.ramp_end, 4);
  auto const& condition = result.velocities.back();
  EXPECT_EQ(condition.direction, (std::vector<double>{0, 2}));
  EXPECT_EQ(condition.velocity({0, 0}, 0), 0);
  EXPECT_NEAR(condition.velocity({0, 0}, 2), 0.5 * 2 * 3, 1e-14);
  EXPECT_NEAR(condition.velocity({1, 0}, 4), 20, 1e-13);
  EXPECT_NEAR(condition.velocity({0, 0}, 9), 20, 1e-13);

  const auto sudden = makeBoundaryConditions<2>(
    driven([](ParameterList& condition) { condition.set("Velocity", 3.); }), 2);
  EXPECT_EQ(sudden.velocities.back().velocity({0, 0}, 0), 3);
}

TEST(BoundarySetup, leavesAnAntisymmetricFaultFreeAcross)
{
  const auto contact = makeBoundaryConditions<2>(conditions({}), 2);
  EXPECT_FALSE(contact.antisymmetric);
  EXPECT_EQ(contact.slipFactor(), 1);
  EXPECT_FALSE(contact.velocities.at(0).free);
  for (int components : {1, 2}) {
    const auto result = makeBoundaryConditions<2>(
      conditions({{"Wall", "right", "Sliding Wall"}, {"Fault", "bottom", "Antisymmetric Fault"}},
                 false),
      components);
    EXPECT_EQ(result.fault, "bottom");
    EXPECT_TRUE(result.antisymmetric);
    EXPECT_EQ(result.slipFactor(), 2);
    if (components == 2) {
      EXPECT_EQ(result.velocities.at(0).boundary, "bottom");
      EXPECT_TRUE(result.velocities.at(0).free);
    } else {
      EXPECT_TRUE(result.velocities.empty());
    }
  }
}

TEST(BoundarySetup, letsTheFaultGoOnAtAPrescribedSlipRate)
{
  for (char const* type : {"Bilateral Contact", "Antisymmetric Fault"}) {
    const double factor = std::string(type) == "Bilateral Contact" ? 1 : 2;
    const auto list = completeDeck([type](ParameterList& deck) {
                        auto& given = deck.sublist("Boundary Conditions");
                        auto& deep = given.sublist("Left");
                        deep.set("Type", "Prescribed Slip Rate").set("Slip Rate", "4 * (x + t)");
                        auto& deeper = given.sublist("Deeper");
                        deeper.set("Boundary", "right").set("Type", "Prescribed Slip Rate");
                        deeper.set("Slip Rate", -6.);
                        given.sublist("Fault").set("Type", type);
                      }).sublist("Boundary Conditions");
    const auto plane = makeBoundaryConditions<2>(list, 2).velocities;
    ASSERT_EQ(plane.size(), 5U);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(plane[i].boundary, (std::array{"bottom", "left", "right"})[i]);
      EXPECT_EQ(plane[i].free, factor == 2);
      EXPECT_FALSE(plane[i].tangential);
      EXPECT_EQ(plane[i].continued_by.size(), 3U) << "one normal where they meet";
    }
    for (int i = 3; i < 5; ++i) {
      EXPECT_TRUE(plane[i].tangential && plane[i].direction.empty() && !plane[i].free);
    }
    EXPECT_EQ(plane[3].velocity({2, 0}, 1), 12 / factor);
    EXPECT_EQ(plane[4].velocity({2, 0}, 1), -6 / factor);

    const auto antiplane = makeBoundaryConditions<2>(list, 1).velocities;
    ASSERT_EQ(antiplane.size(), 2U);
    EXPECT_EQ(antiplane[0].direction, std::vector<double>{1});
    EXPECT_EQ(antiplane[0].velocity({2, 0}, 1), 12 / factor);
  }
}

TEST(BoundarySetup, wantsTheSlipRateThatIsPrescribed)
{
  const auto list = conditions({{"Deep", "left", "Prescribed Slip Rate"}});
  expectParts(refusal([&] { makeBoundaryConditions<2>(list, 2); }),
              {"Asperity / Boundary Conditions / Deep / Slip Rate", "missing"});
}

TEST(BoundarySetup, collectsAbsorbingBoundaries)
{
  const auto result = makeBoundaryConditions<2>(
    conditions({{"A", "left", "Absorbing"}, {"B", "top", "Absorbing"}}), 2);
  EXPECT_EQ(result.absorbing, (std::vector<std::string>{"left", "top"}));
  EXPECT_EQ(result.velocities.size(), 1U);
}

TEST(BoundarySetup, refusesADirectionThatIsNone)
{
  for (auto const& direction : {std::vector<double>{0, 0}, {1}, {1, 0, 0}}) {
    const auto list =
      driven([&](ParameterList& condition) { condition.set("Direction", array(direction)); });
    expectParts(refusal([&] { makeBoundaryConditions<2>(list, 2); }),
                {"Asperity / Boundary Conditions / Left / Direction"});
  }
}

TEST(BoundarySetup, refusesADirectionWhereThereIsOne)
{
  const auto directed = [](char const* type) {
    return driven([type](ParameterList& condition) {
      condition.remove("Velocity", false);
      condition.remove("Direction", false);
      condition.remove("Ramp Duration", false);
      condition.set("Type", type).set("Direction", array<double>({-1, 0}));
      if (std::string(type) == "Prescribed Slip Rate") {
        condition.set("Slip Rate", 1e-9);
      }
    });
  };
  const std::pair<char const*, int> cases[] = {
    {"Prescribed Velocity", 1}, {"Prescribed Slip Rate", 1}, {"Prescribed Slip Rate", 2}};
  for (auto const& [type, components] : cases) {
    const auto list = directed(type);
    expectParts(
      refusal([&, components = components] { makeBoundaryConditions<2>(list, components); }),
      {"Asperity / Boundary Conditions / Left / Direction", "no effect"});
  }
}

TEST(BoundarySetup, refusesConditionsThatContradict)
{
  const std::vector<std::pair<std::string, std::string>> pairs = {
    {"Fixed", "Sliding Wall"},
    {"Sliding Wall", "Fixed"},
    {"Fixed", "Free Surface"},
    {"Free Surface", "Prescribed Velocity"},
    {"Prescribed Velocity", "Free Surface"},
    {"Fixed", "Absorbing"},
    {"Absorbing", "Free Surface"},
    {"Absorbing", "Absorbing"},
    {"Prescribed Slip Rate", "Absorbing"},
    {"Fixed", "Fixed"}};
  for (auto const& [first, second] : pairs) {
    const auto list = conditions({{"A", "top", first}, {"B", "top", second}});
    expectParts(refusal([&] { makeBoundaryConditions<2>(list, 2); }),
                {"Asperity / Boundary Conditions / A", "Asperity / Boundary Conditions / B",
                 "contradicts", "'top'"});
  }
  for (char const* type : {"Fixed", "Absorbing", "Prescribed Slip Rate"}) {
    const auto on_fault = conditions({{"A", "bottom", type}});
    expectParts(refusal([&] { makeBoundaryConditions<2>(on_fault, 2); }),
                {"contradicts", "'bottom'", "Asperity / Boundary Conditions / Fault",
                 "Asperity / Boundary Conditions / A"});
  }
}

TEST(BoundarySetup, refusesEntriesThatItsTypeDoesNotRead)
{
  const std::vector<std::pair<std::string, std::string>> pairs = {
    {"Prescribed Slip Rate", "Ramp Duration"},
    {"Prescribed Velocity", "Slip Rate"},
    {"Sliding Wall", "Slip Rate"},
    {"Fixed", "Velocity"},
    {"Absorbing", "Velocity"},
    {"Prescribed Slip Rate", "Velocity"}};
  for (auto const& [type, entry] : pairs) {
    const auto list = driven([&, type = type, entry = entry](ParameterList& condition) {
      condition.set("Type", type).set(entry, 1.);
    });
    expectParts(refusal([&] { makeBoundaryConditions<2>(list, 2); }),
                {"Asperity / Boundary Conditions / Left / " + entry, "no effect", type});
  }
}

TEST(BoundarySetup, allowsConditionsInDifferentDirections)
{
  const auto list =
    conditions({{"A", "left", "Sliding Wall"}, {"B", "left", "Prescribed Velocity"}});
  EXPECT_EQ(makeBoundaryConditions<2>(list, 2).velocities.size(), 3U);
}

TEST(BoundarySetup, wantsOneFault)
{
  const auto none = conditions({{"A", "left", "Fixed"}}, false);
  expectParts(refusal([&] { makeBoundaryConditions<2>(none, 2); }),
              {"Asperity / Boundary Conditions", "Bilateral Contact", "Antisymmetric Fault"});
  const auto two = conditions({{"Second", "top", "Antisymmetric Fault"}});
  expectParts(refusal([&] { makeBoundaryConditions<2>(two, 2); }), {"already friction"});
}
} // namespace asperity::scenario
