#include "scenario/BoundarySetup.hpp"

#include "SampleDeck.hpp"
#include "unit/base/Refusal.hpp"

namespace asperity::scenario
{
using namespace test;
using asperity::test::array;
using asperity::test::expectParts;
using asperity::test::refusal;

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
             list.sublist("Fault").set("Boundary", "bottom").set("Type", "Friction");
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
  const auto result = makeBoundaryConditions(conditions({{"Wall", "right", "Sliding Wall"},
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
  const auto result = makeBoundaryConditions(
    conditions({{"Wall", "right", "Sliding Wall"}, {"Ground", "left", "Fixed"}}), 1);
  ASSERT_EQ(result.velocities.size(), 1U);
  EXPECT_EQ(result.velocities[0].boundary, "left");
  EXPECT_EQ(result.velocities[0].direction, std::vector<double>{1});
}

TEST(BoundarySetup, prescribesAVelocityWithARamp)
{
  const auto result = makeBoundaryConditions(driven([](ParameterList& condition) {
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

  const auto sudden = makeBoundaryConditions(
    driven([](ParameterList& condition) { condition.set("Velocity", 3.); }), 2);
  EXPECT_EQ(sudden.velocities.back().velocity({0, 0}, 0), 3);
}

TEST(BoundarySetup, refusesADirectionThatIsNone)
{
  for (auto const& direction : {std::vector<double>{0, 0}, {1}, {1, 0, 0}}) {
    const auto list =
      driven([&](ParameterList& condition) { condition.set("Direction", array(direction)); });
    expectParts(refusal([&] { makeBoundaryConditions(list, 2); }),
                {"Asperity / Boundary Conditions / Left / Direction"});
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
    {"Fixed", "Fixed"}};
  for (auto const& [first, second] : pairs) {
    const auto list = conditions({{"A", "top", first}, {"B", "top", second}});
    expectParts(refusal([&] { makeBoundaryConditions(list, 2); }),
                {"Asperity / Boundary Conditions / A", "Asperity / Boundary Conditions / B",
                 "contradicts", "'top'"});
  }
  const auto on_fault = conditions({{"A", "bottom", "Fixed"}});
  expectParts(refusal([&] { makeBoundaryConditions(on_fault, 2); }),
              {"contradicts", "'bottom'", "Asperity / Boundary Conditions / Fault"});
}

TEST(BoundarySetup, allowsConditionsInDifferentDirections)
{
  const auto list =
    conditions({{"A", "left", "Sliding Wall"}, {"B", "left", "Prescribed Velocity"}});
  EXPECT_EQ(makeBoundaryConditions(list, 2).velocities.size(), 3U);
}

TEST(BoundarySetup, wantsOneFault)
{
  const auto none = conditions({{"A", "left", "Fixed"}}, false);
  expectParts(refusal([&] { makeBoundaryConditions(none, 2); }),
              {"Asperity / Boundary Conditions", "'Friction'"});
  const auto two = conditions({{"Second", "top", "Friction"}});
  expectParts(refusal([&] { makeBoundaryConditions(two, 2); }), {"already friction"});
}
} // namespace asperity::scenario
