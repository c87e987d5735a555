#include "scenario/setup/conditions/BoundaryKind.hpp"

#include "SampleDeck.hpp"
#include "base/parallel/Reductions.hpp"
#include "scenario/DeckParameters.hpp"
#include "scenario/problem/Problem.hpp"
#include "scenario/setup/friction/LawSetup.hpp"

#include <Tpetra_Vector.hpp>

#include <functional>
#include <string>
#include <vector>

// Uses the type 'Elastic Foundation' of examples/plugin, which is linked to this test.
namespace asperity::scenario
{
using namespace test;

namespace
{
constexpr double shear_modulus = 1e6, poisson = 0.3, stiffness = 4e5, load = 300; // Pa, -, Pa/m, Pa

// A block of 2 m by 1 m without a fault and without inertia.
ParameterList
block(std::function<void(ParameterList& conditions, ParameterList& bulk)> const& change)
{
  ParameterList deck("Asperity");
  auto& mesh = deck.sublist("Mesh");
  mesh.set("Type", "Rectangle");
  mesh.sublist("Rectangle").set("Width", 2.).set("Height", 1.).set("Cells X", 4).set("Cells Y", 3);
  auto& bulk = deck.sublist("Bulk");
  bulk.set("Dynamics", "Quasi-dynamic").set("Density", 1000.).set("Shear Modulus", shear_modulus);
  bulk.set("Poisson's Ratio", poisson);
  deck.sublist("Time Stepping")
    .set("Final Time", 1.)
    .set("Largest Step", 0.25)
    .set("Smallest Step", 0.25)
    .set("Scheme", "Generalised Alpha")
    .set("Control", "Prescribed");
  change(deck.sublist("Boundary Conditions"), bulk);
  chooseLaws(deck.sublist("Friction"), false);
  completeAndValidate(deck, *deckParameters(), "Asperity");
  return deck;
}

ParameterList& on(ParameterList& conditions, std::string const& boundary, std::string const& type)
{
  return conditions.sublist("On " + boundary).set("Boundary", boundary).set("Type", type);
}

// The displacement at the start at each owned node of an axis-parallel body: expected(x,
// component).
template <class Expected>
void expectDisplacement(ParameterList const& deck, Expected const& expected)
{
  auto const problem = makeProblem<2>(deck, world());
  const auto u = valuesOf(*problem.model.initial.u);
  for (int node = 0; node < problem.mesh().num_owned; ++node) {
    auto const& x = problem.mesh().vertices[node];
    for (int c = 0; c < problem.components(); ++c) {
      EXPECT_NEAR(u[node * problem.components() + c], expected(x, c), 1e-9 * load / stiffness)
        << x[0] << ' ' << x[1];
    }
  }
}
} // namespace

TEST(BoundaryKind, AreThoseOfDecksAndOfPlugins)
{
  EXPECT_EQ(
    BoundaryKindRegistry::instance().names(),
    (std::vector<std::string>{"Absorbing", "Elastic Foundation", "Fixed", "Free Surface",
                              "Prescribed Traction", "Prescribed Velocity", "Sliding Wall"}));
  auto const& springs = conditionType("Elastic Foundation");
  EXPECT_EQ(springs.reads, (std::vector<std::string>{"Normal Stiffness", "Shear Stiffness"}));
  EXPECT_FALSE(springs.is_open);
  EXPECT_TRUE(conditionType("Prescribed Traction").is_open);
}

// Between walls the pressure p presses the block, and the block its springs, by
// u_y = -p / k - p y / (lambda + 2 G).
TEST(BoundaryKind, ABlockSinksIntoSprings)
{
  const auto deck = block([](auto& conditions, auto&) {
    on(conditions, "bottom", "Elastic Foundation").set("Normal Stiffness", stiffness);
    on(conditions, "left", "Sliding Wall");
    on(conditions, "right", "Sliding Wall");
    on(conditions, "top", "Prescribed Traction").set("Pressure", load);
  });
  const double modulus = 2 * shear_modulus * (1 - poisson) / (1 - 2 * poisson);
  expectDisplacement(deck, [&](Point<2> const& x, int c) {
    return c == 0 ? 0 : -load / stiffness - load * x[1] / modulus;
  });
}

// In antiplane motion u = T / k + T x / G.
TEST(BoundaryKind, SpringsAlongABoundaryBearAPullAlongZ)
{
  const auto deck = block([](auto& conditions, auto& bulk) {
    bulk.set("Model", "Antiplane");
    on(conditions, "left", "Elastic Foundation").set("Shear Stiffness", stiffness);
    on(conditions, "right", "Prescribed Traction").set("Traction Z", load);
  });
  expectDisplacement(
    deck, [](Point<2> const& x, int) { return load / stiffness + load * x[0] / shear_modulus; });
}

TEST(BoundaryKind, SpringsMayVaryInSpace)
{
  const auto deck = block([](auto& conditions, auto& bulk) {
    bulk.set("Model", "Antiplane");
    on(conditions, "left", "Elastic Foundation").set("Shear Stiffness", "4e5 * (1 + 2 * y)");
    on(conditions, "right", "Prescribed Traction").set("Traction Z", load);
  });
  auto const problem = makeProblem<2>(deck, world());
  // The sum of the nodal forces of the springs is the load on the right, 300 Pa times 1 m.
  const auto u = valuesOf(*problem.model.initial.u);
  double mine = 0;
  for (int node = 0; node < problem.mesh().num_owned; ++node) {
    auto const& x = problem.mesh().vertices[node];
    if (x[0] == 0) {
      const double share = x[1] == 0 || x[1] == 1 ? 1. / 6 : 1. / 3; // of three facets
      mine += share * stiffness * (1 + 2 * x[1]) * u[node];
    }
  }
  EXPECT_NEAR(sumOverRanks(mine, *world()), load, 1e-9 * load);
}

TEST(BoundaryKind, WhatSpringsDoNotResistIsFree)
{
  const auto on_springs = [](std::function<void(ParameterList&)> const& change) {
    return block([&](auto& conditions, auto&) {
      auto& springs = on(conditions, "bottom", "Elastic Foundation");
      springs.set("Normal Stiffness", stiffness);
      change(springs);
      on(conditions, "top", "Prescribed Traction").set("Pressure", load);
    });
  };
  expectRefusal([&] { makeProblem<2>(on_springs([](auto&) {}), world()); },
                {"nothing stops or resists the body when it moves along x"});
  makeProblem<2>(on_springs([](auto& springs) { springs.set("Shear Stiffness", stiffness); }),
                 world());
}

TEST(BoundaryKind, RefusesWrongEntries)
{
  const auto with = [](std::string const& type, std::string const& entry) {
    return block([&](auto& conditions, auto&) {
      on(conditions, "bottom", type).set(entry, entry == "Velocity" ? "1" : "x - 1.5");
      on(conditions, "left", "Sliding Wall");
    });
  };
  expectRefusal([&] { makeProblem<2>(with("Elastic Foundation", "Normal Stiffness"), world()); },
                {"Normal Stiffness", "-1.5", "[0, inf)"});
  expectRefusal([&] { makeProblem<2>(with("Elastic Foundation", "Velocity"), world()); },
                {"Velocity has no effect", "Prescribed Velocity"});
  expectRefusal([&] { makeProblem<2>(with("Fixed", "Shear Stiffness"), world()); },
                {"Shear Stiffness has no effect", "Elastic Foundation"});
}
} // namespace asperity::scenario
