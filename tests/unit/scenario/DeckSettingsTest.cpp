#include "scenario/problem/DeckSettings.hpp"

#include "SampleDeck.hpp"
#include "scenario/setup/DeckDirections.hpp"

// What a problem takes from its deck.
namespace asperity::scenario
{
using namespace test;

TEST(DeckSettings, HoldEveryListThatAProblemReads)
{
  const auto settings = DeckSettings::from(completeDeck([](ParameterList& deck) {
    deck.sublist("Time Stepping").set("Final Time", 7.);
    deck.sublist("Bulk").set("Gravitational Acceleration", 3.).set("Density", 1234.);
    deck.sublist("Friction").set("Normal Stress Factor", 0.5).set("Cohesion", 11.);
    deck.sublist("Initial State").set("Displacement", "Zero").set("State", "Steady");
    deck.sublist("Initial State").set("Slip Rate", 2.);
    deck.sublist("TNNMG").set("Memory Budget", 5.).set("Maximum Iterations", 4);
    deck.sublist("Time Stepping").sublist("Step Doubling").set("Tolerance", 1e-4);
    deck.sublist("Coupling").set("Maximum Iterations", 9);
    auto& output = deck.sublist("Output");
    output.set("Up", array<double>({0, 0, 1})).set("East", array<double>({0, 1, 0}));
    output.set("Checkpoint Every n Steps", 12);
    output.sublist("Fault History").set("Enabled", true).set("Times", array<double>({5, 6}));
  }));
  EXPECT_EQ(settings.time.final_time, 7);
  ASSERT_EQ(settings.conditions.size(), 2U);
  EXPECT_EQ(settings.conditions.front().boundary, "bottom");
  EXPECT_EQ(settings.mesh.type, "Rectangle");
  EXPECT_EQ(settings.bulk.gravity, 3);
  EXPECT_EQ(settings.friction.normal_stress_factor, 0.5);
  EXPECT_FALSE(settings.initial.is_static);
  EXPECT_TRUE(settings.initial.is_balanced);
  EXPECT_EQ(settings.initial.alpha, dynamics::AlphaAtStart::steady);
  EXPECT_EQ(settings.solver.memoryBudget(), 5000000U);
  EXPECT_EQ(settings.solver.tnnmg.max_iterations, 4);
  EXPECT_EQ(settings.up, (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(settings.east.east, (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(settings.checkpoints.num_steps, 12);
  EXPECT_EQ(settings.output_times, (std::vector<double>{5, 6}));
  EXPECT_EQ(settings.time.tolerance, 1e-4);
  EXPECT_EQ(settings.coupling.max_iterations, 9);
  EXPECT_DOUBLE_EQ(settings.coupling.tolerance, 1e-7) << "a thousandth of that of steps";
  // Fields, which need a mesh.
  EXPECT_EQ(settings.lists.bulk.get<double>("Density"), 1234);
  EXPECT_EQ(settings.lists.friction.get<double>("Cohesion"), 11);
  EXPECT_EQ(settings.lists.initial.get<double>("Slip Rate"), 2);
}

// The directions that a run sets in its deck follow from the mesh, and must not be taken for the
// user's when the deck is read anew.
TEST(DeckSettings, TakeNoDirectionThatTheDeckLeavesOut)
{
  auto deck = completeDeck([](ParameterList&) {});
  completeDirections(deck, 3, {0, 0, 1});
  EXPECT_TRUE(isGiven(deck.sublist("Output"), "Up"));
  const auto settings = DeckSettings::from(deck);
  EXPECT_FALSE(settings.up.has_value());
  EXPECT_FALSE(settings.bulk.gravity_direction.has_value());
  EXPECT_TRUE(isLeftOut(settings.lists.bulk, "Gravity Direction")) << "the copy keeps it so";
}
} // namespace asperity::scenario
