#include "scenario/problem/InitialState.hpp"

#include "SampleDeck.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "scenario/problem/Problem.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
using namespace test;

namespace
{
constexpr double plate_rate = 2e-4; // m/s, of slip: each side moves at half of it

// Uniform sliding of the strip at the plate rate, then changed.
ParameterList sliding(std::function<void(ParameterList&)> const& change = [](auto&) {})
{
  return strip([&](ParameterList& deck) {
    deck.sublist("Friction").set("Shear Traction", steadyStress(plate_rate));
    deck.sublist("Initial State").set("Velocity Z", plate_rate / 2).set("State", "Steady");
    auto& far = deck.sublist("Boundary Conditions").sublist("Far");
    far.set("Boundary", "top").set("Type", "Prescribed Velocity").set("Velocity", plate_rate / 2);
    change(deck);
  });
}

std::vector<double> slipRates(Problem<2> const& problem)
{
  BlockView v("v", problem.surface().numNodes(), 1);
  NodeView V("V", problem.surface().numNodes());
  dynamics::gather(problem.surface(), *problem.model.initial.v, v);
  dynamics::slipRate(problem.surface(), v, V);
  return valuesOf(V);
}

void expectAll(std::vector<double> const& values, double expected, double tolerance)
{
  for (double value : values) {
    EXPECT_NEAR(value, expected, tolerance);
  }
}
} // namespace

TEST(InitialState, LetsAnAntisymmetricStripSlideSteadilyAtTwiceItsVelocity)
{
  for (char const* state : {"Steady", "Stress Balance"}) {
    auto const problem = makeProblem<2>(
      sliding([state](auto& deck) { deck.sublist("Initial State").set("State", state); }), world());
    expectAll(slipRates(problem), plate_rate, 1e-18);
    expectAll(valuesOf(problem.model.initial.alpha), std::log(1e-6 / plate_rate), 1e-12);
    // Balance of momentum: friction at the slip rate, not at the velocity, bears the traction.
    EXPECT_LE(problem.model.initial.a->normInf(), 1e-9);
  }
  auto const bilateral = makeProblem<2>(
    sliding([](auto& deck) {
      deck.sublist("Boundary Conditions").sublist("Fault").set("Type", "Bilateral Contact");
    }),
    world());
  expectAll(slipRates(bilateral), plate_rate / 2, 1e-18);
  EXPECT_GT(bilateral.model.initial.a->normInf(), 1e-4);
}

TEST(InitialState, BalancesTheShearTractionWithFrictionCohesionAndRadiation)
{
  const double tau = 7000, cohesion = 100, V = 1e-2;
  for (bool quasi : {false, true}) {
    auto const problem =
      makeProblem<2>(strip([&](ParameterList& deck) {
                       auto& friction = deck.sublist("Friction");
                       friction.set("Shear Traction", -tau).set("Cohesion", cohesion);
                       auto& initial = deck.sublist("Initial State");
                       initial.set("Velocity Z", -V / 2).set("State", "Stress Balance");
                       deck.sublist("Bulk").set("Dynamics", quasi ? "Quasi-dynamic" : "Inertial");
                     }),
                     world());
    NodeView mu("mu", 3);
    BlockView v("v", 3, 1);
    dynamics::gather(problem.surface(), *problem.model.initial.v, v);
    problem.model.fault.friction().coefficient(v, problem.model.initial.alpha, mu);
    const double radiation = quasi ? std::sqrt(1000 * 1e6) / 2 * V : 0;
    expectAll(valuesOf(mu), (tau - cohesion - radiation) / 1e4, 1e-13);
  }
}

TEST(InitialState, LeavesAColumnUnderObliqueGravityInBalance)
{
  // The static solution has slid without friction, so friction bears the deck's traction alone;
  // were it not so, the fault would jump.
  const auto deck = column([](ParameterList& given) {
    given.sublist("Bulk").set("Gravity Direction", array<double>({1, -2}));
    given.sublist("Initial State").set("Velocity X", 1e-3).set("State", "Stress Balance");
    given.sublist("Initial State").set("alpha", 77.);
    given.sublist("Friction").set("Shear Traction", 5000.).set("Normal Stress", 1e4);
  });
  auto const problem = makeProblem<2>(deck, world());
  ASSERT_GT(problem.model.initial.u->normInf(), 0);
  EXPECT_LE(problem.model.initial.a->normInf(), 1e-7) << "m/s^2, beside 10 of gravity";
  // At the walls, where the fault rests, alpha is the deck's.
  EXPECT_EQ(valuesOf(problem.model.initial.alpha)[0], 77);
  EXPECT_NE(valuesOf(problem.model.initial.alpha)[1], 77);
}

TEST(InitialState, RefusesAStateThatDoesNotExist)
{
  const auto message = [](std::function<void(ParameterList&)> const& change) {
    return refusal([&] { makeProblem<2>(sliding(change), world()); });
  };
  expectParts(
    message([](auto& deck) { deck.sublist("Initial State").set("Velocity Z", "1e-9*x"); }),
    {"Asperity / Initial State / State = Steady", "node 0", "x = (0, 0)", "slip rate is zero"});
  const auto balance = [&](std::function<void(ParameterList&)> const& change) {
    return message([&](ParameterList& deck) {
      deck.sublist("Initial State").set("State", "Stress Balance");
      change(deck);
    });
  };
  expectParts(balance([](auto& deck) { deck.sublist("Friction").set("Shear Traction", "x - 1"); }),
              {"State = Stress Balance", "node 0", "-1 Pa", "signs"});
  expectParts(balance([](auto& deck) { deck.sublist("Friction").set("Normal Stress", "x"); }),
              {"node 0", "no normal stress"});
  expectParts(balance([](auto& deck) { deck.sublist("Friction").set("b", 0.); }),
              {"Friction has to depend on the state"});
}

TEST(InitialState, TakesThePrescribedSlipRateWhereTheFaultEnds)
{
  // The left part of the bottom is the fault, the right part slips at the plate rate.
  const auto deck = sliding([](ParameterList& given) {
    given.sublist("Mesh").sublist("Boundaries").set("deep", "y < 1e-9 && x > 1");
    auto& deep = given.sublist("Boundary Conditions").sublist("Deep");
    deep.set("Boundary", "deep").set("Type", "Prescribed Slip Rate").set("Slip Rate", plate_rate);
    given.sublist("Initial State").set("Velocity Z", 1e-9 / 2);
  });
  auto const problem = makeProblem<2>(deck, world());
  ASSERT_EQ(problem.surface().numNodes(), 2);
  EXPECT_EQ(heldComponents(problem.surface()), (std::vector<std::vector<int>>{{0}, {1}}));
  EXPECT_NEAR(slipRates(problem)[0], 1e-9, 1e-24);
  EXPECT_NEAR(slipRates(problem)[1], plate_rate, 1e-18);
  EXPECT_NEAR(valuesOf(problem.model.initial.alpha)[1], std::log(1e-6 / plate_rate), 1e-12);
}

// In the static solution a fault that may open is shut: the weight of the upper half presses it.
TEST(InitialState, ShutsAFaultThatMayOpen)
{
  const auto onContact = [](std::string const& contact) {
    return makeProblem<2>(column([&](ParameterList& given) {
                            auto& conditions = given.sublist("Boundary Conditions");
                            conditions.sublist("Fault").set("Boundary", "main");
                            conditions.sublist("Fault").set("Type", "Two-Sided Fault");
                            conditions.sublist("Fault").set("Contact", contact);
                            conditions.sublist("Ground").set("Boundary", "bottom");
                            conditions.sublist("Ground").set("Type", "Fixed");
                            given.sublist("Mesh").sublist("Faults").set("main",
                                                                        "abs(y - 1) < 1e-6");
                            given.sublist("Friction").set("Normal Stress Change", "Coupled");
                          }),
                          world());
  };
  const auto shut = onContact("Bilateral"), opens = onContact("Unilateral");
  ASSERT_TRUE(opens.surface().mayOpen());
  expectNear(valuesOf(opens.model.initial.sigma_n), valuesOf(shut.model.initial.sigma_n));
  expectNear(valuesOf(*opens.model.initial.u), valuesOf(*shut.model.initial.u));
  double largest = 0;
  for (const double stress : valuesOf(opens.model.initial.sigma_n)) {
    largest = std::max(largest, stress);
  }
  EXPECT_NEAR(largest, 1e4, 2e3); // 1000 kg/m^3, 10 m/s^2, 1 m, on two cells
}

TEST(InitialState, WarnsOfAVelocityThatMovesBothSidesOfAFault)
{
  const auto warns = [](std::function<void(ParameterList&)> const& change) {
    const auto deck = strip([&](ParameterList& given) {
      auto& conditions = given.sublist("Boundary Conditions");
      conditions.sublist("Fault").set("Boundary", "main").set("Type", "Two-Sided Fault");
      for (std::string const side : {"top", "bottom"}) {
        conditions.sublist(side).set("Boundary", side).set("Type", "Fixed");
      }
      given.sublist("Mesh").sublist("Faults").set("main", "abs(y - 1) < 1e-6");
      given.sublist("Bulk").set("Dynamics", "Quasi-dynamic");
      change(given);
    });
    const auto problem = makeProblem<2>(deck, world());
    return std::any_of(problem.findings.warnings.begin(), problem.findings.warnings.end(),
                       [](Warning const& warning) { return warning.topic == "initial velocity"; });
  };
  const auto moves = [](ParameterList& deck) {
    deck.sublist("Initial State").set("Velocity Z", 1e-9);
  };
  EXPECT_TRUE(warns(moves));
  EXPECT_FALSE(warns([](ParameterList&) {})) << "at rest";
  EXPECT_FALSE(warns([&](ParameterList& deck) {
    moves(deck);
    deck.sublist("Initial State").set("Slip Rate", 1e-9);
  }));
  EXPECT_FALSE(warns([&](ParameterList& deck) {
    moves(deck);
    deck.sublist("Bulk").set("Dynamics", "Inertial");
  }))
    << "it may be a wave";
}
} // namespace asperity::scenario
