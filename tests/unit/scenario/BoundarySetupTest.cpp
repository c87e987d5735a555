#include "scenario/setup/conditions/BoundarySetup.hpp"

#include "SampleDeck.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"

#include <set>

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

template <class Kind, int Dim>
bool is(fem::VelocityCondition<Dim> const& condition)
{
  return std::holds_alternative<Kind>(condition.kind);
}

template <class Kind, int Dim>
Kind const& as(fem::VelocityCondition<Dim> const& condition)
{
  return std::get<Kind>(condition.kind);
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

template <int Dim>
BoundaryConditions<Dim> make(ParameterList const& list, int components)
{
  return makeBoundaryConditions<Dim>(readConditions(list), components);
}
} // namespace

TEST(BoundarySetup, TurnsConditionsIntoPrescribedVelocities)
{
  const auto result = make<2>(conditions({{"Wall", "right", "Sliding Wall"},
                                          {"Ground", "left", "Fixed"},
                                          {"Air", "top", "Free Surface"}}),
                              2);
  EXPECT_EQ(result.faults, fem::Boundaries{"bottom"});
  EXPECT_EQ(result.surface, "top");
  ASSERT_EQ(result.velocities.size(), 4U);
  // The contact of the fault is the first, so that frames follow it.
  EXPECT_EQ(result.velocities[0].boundary, "bottom");
  EXPECT_TRUE(is<fem::ContactAcrossFault>(result.velocities[0]));
  std::vector<std::vector<double>> fixed;
  for (auto const& condition : result.velocities) {
    if (condition.boundary == "left") {
      fixed.push_back(as<fem::AtRestAlong>(condition).d);
    } else if (condition.boundary == "right") {
      EXPECT_TRUE(is<fem::SlidingWall>(condition));
    }
  }
  EXPECT_EQ(fixed, (std::vector<std::vector<double>>{{1, 0}, {0, 1}}));
}

TEST(BoundarySetup, HasNoNormalInAntiplane)
{
  const auto result =
    make<2>(conditions({{"Wall", "right", "Sliding Wall"}, {"Ground", "left", "Fixed"}}), 1);
  ASSERT_EQ(result.velocities.size(), 1U);
  EXPECT_EQ(result.velocities[0].boundary, "left");
  EXPECT_EQ(as<fem::AtRestAlong>(result.velocities[0]).d, std::vector<double>{1});
}

TEST(BoundarySetup, PrescribesAVelocityWithARamp)
{
  const auto result = make<2>(driven([](ParameterList& condition) {
                                condition.set("Velocity", "2 * (1 + x) * (1 + t)");
                                condition.set("Ramp Duration", 4.);
                                condition.set("Direction", array<double>({0, 2}));
                              }),
                              2);
  auto const& push = as<fem::PrescribedVelocity<2>>(result.velocities.back());
  EXPECT_EQ(push.d, (std::vector<double>{0, 2}));
  EXPECT_EQ(push.velocity({0, 0}, 0), 0);
  EXPECT_NEAR(push.velocity({0, 0}, 2), 0.5 * 2 * 3, 1e-14);
  EXPECT_NEAR(push.velocity({1, 0}, 4), 20, 1e-13);
  EXPECT_NEAR(push.velocity({0, 0}, 9), 20, 1e-13);

  const auto sudden =
    make<2>(driven([](ParameterList& condition) { condition.set("Velocity", 3.); }), 2);
  EXPECT_EQ(sudden.velocities.back().velocity({0, 0}, 0), 3);
}

TEST(BoundarySetup, LeavesAFaultThatMayOpenFreeAcross)
{
  const auto withContact = [](std::string const& contact, std::string const& slip_rate = "") {
    return completeDeck([&](ParameterList& deck) {
             deck.remove("Boundary Conditions");
             auto& list = deck.sublist("Boundary Conditions");
             for (std::string const name : {"first", "second"}) {
               list.sublist(name).set("Boundary", name).set("Type", "Two-Sided Fault");
             }
             auto& second = list.sublist("second");
             if (!contact.empty()) {
               second.set("Contact", contact);
             }
             if (!slip_rate.empty()) {
               second.set("Slip Rate", slip_rate);
             }
           })
      .sublist("Boundary Conditions");
  };
  for (std::string const contact : {"", "Bilateral", "Unilateral"}) {
    const auto result = make<2>(withContact(contact), 2);
    const bool may_open = contact == "Unilateral";
    EXPECT_EQ(result.other_side.may_open, may_open);
    ASSERT_EQ(result.velocities.size(), 2U);
    for (auto const& condition : result.velocities) {
      EXPECT_EQ(is<fem::FreeAcrossFault>(condition), may_open && condition.boundary == "second");
      EXPECT_EQ(is<fem::ContactAcrossFault>(condition), !may_open || condition.boundary == "first");
    }
  }
  expectRefusal([&] { make<2>(withContact("Unilateral"), 1); },
                {"second / Contact = Unilateral", "antiplane motion does not open"});
  expectRefusal([&] { make<2>(withContact("Unilateral", "1e-9"), 2); },
                {"second / Contact = Unilateral", "has a Slip Rate"});
}

TEST(BoundarySetup, LeavesAnAntisymmetricFaultFreeAcross)
{
  const auto contact = make<2>(conditions({}), 2);
  EXPECT_FALSE(contact.other_side.is_mirrored);
  EXPECT_TRUE(is<fem::ContactAcrossFault>(contact.velocities.at(0)));
  for (int components : {1, 2}) {
    const auto result = make<2>(
      conditions({{"Wall", "right", "Sliding Wall"}, {"Fault", "bottom", "Antisymmetric Fault"}},
                 false),
      components);
    EXPECT_EQ(result.faults, fem::Boundaries{"bottom"});
    EXPECT_TRUE(result.other_side.is_mirrored);
    if (components == 2) {
      EXPECT_EQ(result.velocities.at(0).boundary, "bottom");
      EXPECT_TRUE(is<fem::FreeAcrossFault>(result.velocities.at(0)));
    } else {
      EXPECT_TRUE(result.velocities.empty());
    }
  }
}

TEST(BoundarySetup, LetsTheFaultGoOnAtAPrescribedSlipRate)
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
    const auto plane = make<2>(list, 2).velocities;
    const std::vector<std::string> along = {"bottom", "left", "right"};
    ASSERT_EQ(plane.size(), 5U);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(plane[i].boundary, along[i]);
      EXPECT_EQ(is<fem::ContactAcrossFault>(plane[i]), factor == 1);
      EXPECT_EQ(is<fem::FreeAcrossFault>(plane[i]), factor == 2);
      EXPECT_EQ(plane[i].boundariesOfNormal(), along) << "one normal where they meet";
    }
    for (int i = 3; i < 5; ++i) {
      EXPECT_TRUE(is<fem::SlipAlongTangent<2>>(plane[i]));
      EXPECT_EQ(plane[i].boundariesOfNormal(), along);
    }
    EXPECT_EQ(plane[3].velocity({2, 0}, 1), 12 / factor);
    EXPECT_EQ(plane[4].velocity({2, 0}, 1), -6 / factor);

    const auto antiplane = make<2>(list, 1).velocities;
    ASSERT_EQ(antiplane.size(), 2U);
    EXPECT_EQ(as<fem::PrescribedVelocity<2>>(antiplane[0]).d, std::vector<double>{1});
    EXPECT_EQ(antiplane[0].velocity({2, 0}, 1), 12 / factor);
  }
}

// Of two faults: one under plates, and one that slips at a known rate, with or without plates.
TEST(BoundarySetup, TakesTheOwnPlatesOfAFaultWhoseSlipIsKnown)
{
  const auto knownSlip = [](char const* of_known) {
    const auto list = completeDeck([of_known](ParameterList& deck) {
                        auto& given = deck.sublist("Boundary Conditions");
                        auto& plates = given.sublist("Fault");
                        plates.set("Type", "Two-Sided Fault").set("Plate Rate", "2");
                        auto& known = given.sublist("Known");
                        known.set("Boundary", "known").set("Type", "Two-Sided Fault");
                        known.set("Slip Rate", "5");
                        if (of_known != nullptr) {
                          known.set("Plate Rate", of_known);
                        }
                      }).sublist("Boundary Conditions");
    for (auto const& condition : make<2>(list, 2).velocities) {
      if (condition.boundary == "known" && is<fem::SlipAlongTangent<2>>(condition)) {
        return condition.velocity({0, 0}, 0);
      }
    }
    return -1.;
  };
  EXPECT_EQ(knownSlip(nullptr), 5);
  EXPECT_EQ(knownSlip("3"), 5 - 3);
}

TEST(BoundarySetup, SlipsInSpaceTowardsItsDirectionAndNotSideways)
{
  const auto list = driven([](ParameterList& condition) {
    condition.remove("Velocity", false);
    condition.remove("Ramp Duration", false);
    condition.set("Type", "Prescribed Slip Rate").set("Slip Rate", 3.);
    condition.set("Direction", array<double>({0, 0, 2}));
  });
  const auto result = make<3>(list, 3).velocities;
  ASSERT_GE(result.size(), 2U);
  auto const& along = as<fem::SlipTowards<3>>(result[result.size() - 2]);
  auto const& sideways = as<fem::NoSlipSideways>(result.back());
  EXPECT_EQ(along.d, (std::vector<double>{0, 0, 2}));
  EXPECT_EQ(along.velocity({0, 0, 0}, 1), 3);
  EXPECT_EQ(sideways.d, along.d);
  EXPECT_EQ(sideways.continuations, along.continuations);
}

// A driven boundary that meets the fault holds what it prescribes, and nothing across that.
TEST(BoundarySetup, HoldsOneDirectionWhereADrivenBoundaryMeetsTheFault)
{
  for (double velocity : {0., 2.}) {
    const auto result = make<3>(driven([velocity](ParameterList& condition) {
                                  condition.remove("Direction", false);
                                  condition.set("Velocity", velocity);
                                }),
                                3)
                          .velocities;
    ASSERT_EQ(result.size(), 2U);
    EXPECT_TRUE(is<fem::ContactAcrossFault>(result.front()));
    EXPECT_TRUE(is<fem::PrescribedVelocity<3>>(result.back()));
  }
}

TEST(BoundarySetup, KnowsWhoReadsEachEntry)
{
  std::set<std::string> read = {"Boundary", "Type"};
  for (auto const& type : conditionTypes()) {
    read.insert(type.reads.begin(), type.reads.end());
  }
  std::set<std::string> declared;
  const auto parameters = boundaryParameters();
  for (auto const& entry : parameters->sublist("<condition>")) {
    declared.insert(entry.first);
  }
  EXPECT_EQ(read, declared);
}

TEST(BoundarySetup, WantsTheSlipRateThatIsPrescribed)
{
  const auto list = conditions({{"Deep", "left", "Prescribed Slip Rate"}});
  expectRefusal([&] { make<2>(list, 2); },
                {"Asperity / Boundary Conditions / Deep / Slip Rate", "missing"});
}

TEST(BoundarySetup, CollectsAbsorbingBoundaries)
{
  const auto result =
    make<2>(conditions({{"A", "left", "Absorbing"}, {"B", "top", "Absorbing"}}), 2);
  ASSERT_EQ(result.resistances.size(), 2U);
  EXPECT_EQ(result.resistances[0].boundary, "left");
  EXPECT_EQ(result.resistances[1].boundary, "top");
  EXPECT_TRUE(result.resistances[0].absorbs_waves);
  EXPECT_EQ(result.velocities.size(), 1U);
}

TEST(BoundarySetup, RefusesADirectionThatIsNone)
{
  for (auto const& direction : {std::vector<double>{0, 0}, {1}, {1, 0, 0}}) {
    const auto list =
      driven([&](ParameterList& condition) { condition.set("Direction", array(direction)); });
    expectRefusal([&] { make<2>(list, 2); }, {"Asperity / Boundary Conditions / Left / Direction"});
  }
}

TEST(BoundarySetup, RefusesADirectionWhereThereIsOne)
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
    expectParts(refusal([&, components = components] { make<2>(list, components); }),
                {"Asperity / Boundary Conditions / Left / Direction", "no effect"});
  }
}

TEST(BoundarySetup, RefusesConditionsThatContradict)
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
    expectRefusal([&] { make<2>(list, 2); },
                  {"Asperity / Boundary Conditions / A", "Asperity / Boundary Conditions / B",
                   "contradicts", "'top'"});
  }
  for (char const* type : {"Fixed", "Absorbing", "Prescribed Slip Rate"}) {
    const auto on_fault = conditions({{"A", "bottom", type}});
    expectRefusal([&] { make<2>(on_fault, 2); },
                  {"contradicts", "'bottom'", "Asperity / Boundary Conditions / Fault",
                   "Asperity / Boundary Conditions / A"});
  }
}

TEST(BoundarySetup, RefusesEntriesThatItsTypeDoesNotRead)
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
    expectRefusal([&] { make<2>(list, 2); },
                  {"Asperity / Boundary Conditions / Left / " + entry, "no effect", type});
  }
}

TEST(BoundarySetup, AllowsConditionsInDifferentDirections)
{
  const auto list =
    conditions({{"A", "left", "Sliding Wall"}, {"B", "left", "Prescribed Velocity"}});
  EXPECT_EQ(make<2>(list, 2).velocities.size(), 3U);
}

TEST(BoundarySetup, WantsAtMostOneFaultOfMostTypes)
{
  const auto none = conditions({{"A", "left", "Fixed"}}, false);
  EXPECT_TRUE(make<2>(none, 2).faults.empty());
  const auto two = conditions({{"Second", "top", "Antisymmetric Fault"}});
  expectRefusal([&] { make<2>(two, 2); }, {"there is already a fault"});
}
} // namespace asperity::scenario
