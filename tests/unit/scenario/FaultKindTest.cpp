#include "scenario/setup/conditions/FaultKind.hpp"

#include "SampleDeck.hpp"
#include "parameters/Deck.hpp"
#include "scenario/problem/Problem.hpp"
#include "scenario/run/OtherRun.hpp"
#include "scenario/setup/conditions/BoundarySetup.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"
#include "unit/base/TemporaryDirectory.hpp"

namespace asperity::scenario
{
using namespace test;

namespace
{
// All that a new kind of fault is.
struct ThreefoldFault : FaultKind
{
  ThreefoldFault()
      : FaultKind{"it slips three times as far as its body moves.", {3, 2, false, true}}
  {
  }
};

fem::OtherSide otherSideOf(std::string const& name)
{
  return FaultKindRegistry::instance().at(name).other_side;
}
} // namespace

ASPERITY_REGISTER(FaultKindRegistry, "Threefold Fault", ThreefoldFault)

TEST(FaultKind, TheThreeOfDecksDifferByTheirMap)
{
  auto const foundation = otherSideOf("Bilateral Contact");
  EXPECT_EQ(foundation.slip_factor, 1) << "slip = v_t";
  EXPECT_EQ(foundation.deforming_sides, 1);
  EXPECT_FALSE(foundation.is_inside || foundation.is_mirrored);

  auto const mirror = otherSideOf("Antisymmetric Fault");
  EXPECT_EQ(mirror.slip_factor, 2) << "slip = 2 v_t";
  EXPECT_EQ(mirror.deforming_sides, 2);
  EXPECT_TRUE(mirror.is_mirrored && !mirror.is_inside);

  auto const body = otherSideOf("Two-Sided Fault");
  EXPECT_EQ(body.slip_factor, 1) << "slip = d_t";
  EXPECT_EQ(body.deforming_sides, 2);
  EXPECT_TRUE(body.is_inside && !body.is_mirrored);
  EXPECT_EQ(faultKindsInside(), std::vector<std::string>{"Two-Sided Fault"});
  for (auto const& name : faultKinds()) {
    EXPECT_EQ(faultKindOf(otherSideOf(name)), name);
  }
  EXPECT_EQ(faultKindOf({5, 1, false, false}), "");
}

TEST(FaultKind, IsOneFile)
{
  const auto deck = column([](ParameterList& given) {
    auto& conditions = given.sublist("Boundary Conditions");
    conditions.sublist("Fault").set("Type", "Threefold Fault");
    given.sublist("Mesh").sublist("Rectangle").set("Cells X", 8);
    given.sublist("Bulk").set("Gravitational Acceleration", 0.);
    given.sublist("Initial State").set("Displacement", "Zero");
    given.sublist("Mesh").sublist("Boundaries").set("deep", "y < 1e-9 && abs(x - 1) < 0.6");
    conditions.sublist("Deep").set("Boundary", "deep").set("Type", "Prescribed Slip Rate");
    conditions.sublist("Deep").set("Slip Rate", 6.);
    given.sublist("Friction").set("Normal Stress", 1e4);
  });
  const auto result =
    makeBoundaryConditions<2>(readConditions(deck.sublist("Boundary Conditions")), 2);
  ASSERT_FALSE(result.velocities.empty());
  EXPECT_TRUE(std::holds_alternative<fem::FreeAcrossFault>(result.velocities.front().kind));
  auto const problem = makeProblem<2>(deck, world());
  EXPECT_EQ(problem.surface().slipFactor(), 3);

  for (auto const& condition : result.velocities) {
    if (condition.name == "Asperity / Boundary Conditions / Deep" &&
        std::holds_alternative<fem::SlipAlongTangent<2>>(condition.kind)) {
      EXPECT_EQ(condition.velocity({0, 0}, 0), 2) << "slip rate 6 = 3 v_t";
      return;
    }
  }
  FAIL() << "nothing slips at depth";
}

// Both have the same values but for the factor.
TEST(FaultKind, IsToldApartInTheStateOfAnotherRun)
{
  const asperity::test::TemporaryDirectory run;
  writeParameters(
    strip([](ParameterList& given) {
      given.sublist("Boundary Conditions").sublist("Fault").set("Type", "Threefold Fault");
    }),
    run.file("parameters.xml"));
  auto const deck = strip();
  auto const problem = makeProblem<2>(deck, world());
  expectRefusal([&] { stateOfOtherRun(run.file("."), problem, {}, dynamics::DyadicTime(1, 0), 1); },
                {"is 'Antisymmetric Fault', but 'Threefold Fault' in the run"});
}
} // namespace asperity::scenario
