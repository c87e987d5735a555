#include "scenario/problem/Upright.hpp"
#include "SampleDeck.hpp"
#include "scenario/problem/Problem.hpp"
#include "scenario/setup/DeckDirections.hpp"

#include <gtest/gtest.h>

// Where up is, by the deck and by the free surface.
namespace asperity::scenario
{
using namespace test;

namespace
{
using Direction = std::array<double, 3>;

ParameterList deckWith(std::vector<double> const& up, std::vector<double> const& down,
                       double acceleration = 10)
{
  return completeDeck([&](ParameterList& deck) {
    deck.sublist("Bulk").set("Gravitational Acceleration", acceleration);
    if (!up.empty()) {
      deck.sublist("Output").set("Up", array(up));
    }
    if (!down.empty()) {
      deck.sublist("Bulk").set("Gravity Direction", array(down));
    }
  });
}

Upright upOf(ParameterList const& deck, int dimension, OuterSurface const& surface,
             OuterSurface const& open = {})
{
  return uprightOf(BulkSettings::from(deck.sublist("Bulk")), givenUp(deck.sublist("Output")),
                   dimension, surface, open);
}

OuterSurface facing(Direction const& normal) { return {{"top"}, {normal, 1}}; }

Upright inSpace(OuterSurface const& surface, std::vector<double> const& up = {},
                std::vector<double> const& down = {}, OuterSurface const& open = {})
{
  return upOf(deckWith(up, down), 3, surface, open);
}
} // namespace

TEST(Upright, FollowsFromTheFreeSurface)
{
  EXPECT_EQ(inSpace(facing({0, 0, 1})).up, (Direction{0, 0, 1}));
  EXPECT_EQ(inSpace(facing({0, 0, 1})).down, (Direction{0, 0, -1}));
  EXPECT_EQ(inSpace(facing({-1, 0, 0})).up, (Direction{-1, 0, 0}));
  EXPECT_EQ(inSpace(facing({-0.28, 0.96, 0})).up, (Direction{0, 1, 0})) << "a slope";
  EXPECT_EQ(inSpace(facing({0.6, 0, 0.8})).up, (Direction{0, 0, 1}));
  const Direction tilted = {0.64, 0.48, 0.6};
  EXPECT_EQ(inSpace(facing(tilted)).up, tilted) << "nearest to no axis";
}

TEST(Upright, FollowsFromWhatNothingHoldsWithoutAFreeSurface)
{
  auto const found = inSpace({}, {}, {}, facing({0, 0, 1}));
  EXPECT_EQ(found.up, (Direction{0, 0, 1}));
  EXPECT_EQ(found.down, (Direction{0, 0, -1}));
  EXPECT_TRUE(found.is_known);
  EXPECT_EQ(inSpace(facing({0, 1, 0}), {}, {}, facing({0, 0, 1})).up, (Direction{0, 1, 0}));
  EXPECT_EQ(inSpace({}, {0, 1, 0}, {}, facing({0, 0, 1})).up, (Direction{0, 1, 0}));
  EXPECT_EQ(inSpace({}, {}, {0, -1, 0}, facing({0, 0, 1})).up, (Direction{0, 1, 0}));
  EXPECT_EQ(upOf(deckWith({}, {}, 0), 3, {}, facing({0, 0, 1})).up, (Direction{0, 1, 0}))
    << "no gravity";
  EXPECT_EQ(upOf(deckWith({}, {}), 2, {}, facing({1, 0, 0})).up, (Direction{0, 1, 0}))
    << "in the plane";
}

TEST(Upright, IsYWithoutASurfaceThatFacesSomewhere)
{
  for (auto const& surface : {OuterSurface{}, OuterSurface{{"all around"}, {{1e-9, 0, 0.01}, 6}}}) {
    auto const found = inSpace(surface);
    EXPECT_EQ(found.up, (Direction{0, 1, 0}));
    EXPECT_EQ(found.down, (Direction{0, -1, 0}));
    EXPECT_FALSE(found.is_known);
  }
  const OuterSurface two_ways = {{"left", "top"}, {{-1, 1, 0}, 2}};
  EXPECT_FALSE(inSpace({}, {}, {}, two_ways).is_known);
  auto const found = inSpace({}, {}, {0.1, 0, -2});
  EXPECT_EQ(found.up, (Direction{0, 0, 1})) << "against gravity";
  EXPECT_NEAR(found.down[0], 0.1 / std::hypot(0.1, 2), 1e-15);
}

TEST(Upright, IsThatOfTheDeck)
{
  auto const found = inSpace(facing({0, 0, 1}), {0, 0.28, 0.96}, {0.27, 0, -1});
  EXPECT_NEAR(found.up[1], 0.28, 1e-15);
  EXPECT_NEAR(found.down[0] / found.down[2], -0.27, 1e-15);
}

TEST(Upright, RefusesContradictions)
{
  expectRefusal(
    [] {
      inSpace(facing({0, 0, 1}), {0, 1, 0}); // what it is without a surface
    },
    {"Asperity / Output / Up = {0, 1, 0}", "'top' faces {0, 0, 1}", "90 degrees",
     "Give {0, 0, 1}"});
  expectRefusal(
    [] {
      inSpace(facing({0, 0, 1}), {}, {0, -1});
    },
    {"Asperity / Bulk / Gravity Direction = {0, -1, 0}", "'top' faces {0, 0, 1}",
     "Give {0, 0, -1}"});
  expectRefusal(
    [] {
      inSpace({}, {0, 0, 1}, {0, -1, 0});
    },
    {"Gravity Direction", "Output / Up = {0, 0, 1}", "90 degrees"});
  // Gravity that does not act contradicts nothing.
  EXPECT_EQ(upOf(deckWith({}, {0, -1}, 0), 3, facing({0, 0, 1})).up, (Direction{0, 0, 1}));
  // In a plane there is no Up.
  EXPECT_EQ(upOf(deckWith({0, 0, 1}, {}), 2, facing({0, 1, 0})).up, (Direction{0, 1, 0}));
}

// Whoever reads the deck of a run finds the directions, and a deck that gives them keeps them.
TEST(Upright, CompletesTheDeck)
{
  auto deck = deckWith({}, {});
  completeDirections(deck, 3, inSpace(facing({0, 0, 1})).up);
  EXPECT_EQ(deck.sublist("Output").get<Teuchos::Array<double>>("Up"), array<double>({0, 0, 1}));
  EXPECT_EQ(deck.sublist("Bulk").get<Teuchos::Array<double>>("Gravity Direction"),
            array<double>({0, 0, -1}));
  auto plane = deckWith({}, {});
  completeDirections(plane, 2, upOf(plane, 2, facing({0, 1, 0})).up);
  EXPECT_EQ(plane.sublist("Bulk").get<Teuchos::Array<double>>("Gravity Direction"),
            array<double>({0, -1}));
  auto given = deckWith({}, {0.27, -1});
  completeDirections(given, 2, upOf(given, 2, {}).up);
  EXPECT_EQ(given.sublist("Bulk").get<Teuchos::Array<double>>("Gravity Direction"),
            array<double>({0.27, -1}));
  auto weightless = deckWith({}, {}, 0);
  completeDirections(weightless, 3, upOf(weightless, 3, facing({0, 0, 1})).up);
  EXPECT_EQ(weightless.sublist("Bulk").get<Teuchos::Array<double>>("Gravity Direction"),
            array<double>({0, 0, -1}))
    << "down, whether gravity acts or not";
}

// The column of SampleDeck lies on its side: its free surface faces +x, and it presses on its left
// side.
TEST(Upright, LetsRockPressAgainstItsFoundation)
{
  auto const problem = makeProblem<2>(
    completeDeck([](ParameterList& deck) {
      auto& conditions = deck.sublist("Boundary Conditions");
      conditions.sublist("Fault").set("Boundary", "left");
      conditions.sublist("Left").set("Boundary", "bottom");
      conditions.sublist("Top").set("Boundary", "top").set("Type", "Sliding Wall");
      conditions.sublist("Surface").set("Boundary", "right").set("Type", "Free Surface");
    }),
    world());
  auto const sigma_n = valuesOf(problem.model.initial.sigma_n);
  ASSERT_EQ(sigma_n.size(), 3U);
  EXPECT_NEAR((sigma_n[0] + 2 * sigma_n[1] + sigma_n[2]) / 4, 1000. * 10 * 2, 1e-6)
    << "the mean: density, acceleration, height";
  EXPECT_EQ(problem.discretisation.upright.up, (Direction{1, 0, 0}));
}
} // namespace asperity::scenario
