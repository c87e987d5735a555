#include "SampleDeck.hpp"
#include "scenario/fields/OutputFields.hpp"
#include "scenario/problem/Problem.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <Tpetra_Vector.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

// Problems in three dimensions.
namespace asperity::scenario
{
using namespace test;

namespace
{
// Eight cubes of a metre between four sliding walls, on a fault below them.
ParameterList block(std::function<void(ParameterList&)> const& change = [](auto&) {})
{
  return completeDeck([&](ParameterList& deck) {
    deck.sublist("Mesh").remove("Rectangle");
    auto& mesh = deck.sublist("Mesh").set("Type", "Box").sublist("Box");
    mesh.set("Size", array<double>({2, 2, 2}));
    mesh.set("Cells X", 2).set("Cells Y", 2).set("Cells Z", 2);
    deck.sublist("Bulk").set("Model", "Solid");
    for (auto const* side : {"left", "right", "front", "back"}) {
      auto& wall = deck.sublist("Boundary Conditions").sublist(std::string("Wall ") + side);
      wall.set("Boundary", side).set("Type", "Sliding Wall");
    }
    deck.sublist("Boundary Conditions").remove("Left");
    change(deck);
  });
}

// The same without walls and weight, half of a body that an antisymmetric fault cuts.
ParameterList halfSpace(std::function<void(ParameterList&)> const& change = [](auto&) {})
{
  return block([&](ParameterList& deck) {
    deck.sublist("Bulk").set("Gravitational Acceleration", 0.);
    deck.sublist("Friction").set("Normal Stress", 1e4);
    auto& conditions = deck.sublist("Boundary Conditions");
    for (auto const* side : {"left", "right", "front", "back"}) {
      conditions.remove(std::string("Wall ") + side);
    }
    conditions.sublist("Fault").set("Type", "Antisymmetric Fault");
    deck.sublist("Initial State").set("Displacement", "Zero");
    change(deck);
  });
}

std::vector<double> onFault(Problem<3> const& problem, std::string const& name)
{
  dynamics::EnergyBalance balance(problem.model.body, problem.model.fault,
                                  makeClock(problem.settings.time));
  balance.start(problem.model.initial);
  dynamics::FaultSample sample(problem.surface(), *problem.model.initial.u);
  sample.begin(problem.model.initial, 0, balance);
  RunView view;
  view.state = &problem.model.initial;
  view.fault = &sample;
  view.balance = &balance;
  auto const domains = makeDomains(problem);
  io::FieldRegistry registry;
  registerFields(registry, problem, view, domains, {});
  std::vector<double> values;
  registry.field("fault", name).values(values);
  return values;
}
} // namespace

TEST(Solid, MeansOnTheFaultKeepTheIntegralOfAField)
{
  auto const problem = makeProblem<3>(halfSpace([](auto& deck) {
                                        deck.sublist("Friction")
                                          .set("Normal Stress", "mean(1e4)")
                                          .set("Cohesion", "1e3 * mean(1 + x + 2 * z)");
                                      }),
                                      world());
  auto const cohesion = valuesOf(problem.model.fault.laws().cohesion);
  auto const weights = weightsOf(problem.surface());
  EXPECT_NEAR(std::inner_product(weights.begin(), weights.end(), cohesion.begin(), 0.), 16e3, 1e-9);
  for (const double sigma_n : valuesOf(problem.model.initial.sigma_n)) {
    EXPECT_EQ(sigma_n, 1e4);
  }
}

TEST(Solid, PressesOnTheFaultWithItsWeight)
{
  auto const problem = makeProblem<3>(block(), world());
  EXPECT_EQ(problem.components(), 3);
  EXPECT_EQ(problem.surface().numTangents(), 2);
  EXPECT_NEAR(problem.surface().totalWeight(), 4, 1e-14);
  const auto pressure = valuesOf(problem.model.initial.sigma_n);
  const auto weight = weightsOf(problem.surface());
  const double expected = 1000 * 10 * 8; // density, gravity, volume
  EXPECT_NEAR(std::inner_product(pressure.begin(), pressure.end(), weight.begin(), 0.), expected,
              1e-9 * expected);
}

// The walls hold one tangent of the nodes at an edge of the fault, both at its corners.
TEST(Solid, KeepsTheDirectionsThatWallsLeaveFree)
{
  auto const problem = makeProblem<3>(block(), world());
  int num_free[3] = {};
  for (auto const& fixed : heldComponents(problem.surface())) {
    ++num_free[2 - std::accumulate(fixed.begin(), fixed.end(), 0)];
  }
  EXPECT_EQ(num_free[2], 1);
  EXPECT_EQ(num_free[1], 4);
  EXPECT_EQ(num_free[0], 4);
}

TEST(Solid, PullsTheFaultAlongTheSlipDirection)
{
  const auto deck = halfSpace([](ParameterList& given) {
    given.sublist("Friction").set("Shear Traction", "100 * (1 + t)");
    given.sublist("Friction").set("Slip Direction", array<double>({3, 7, 4})); // y is across
  });
  auto const problem = makeProblem<3>(deck, world());
  for (double t : {0., 2.}) {
    auto const load = problem.model.body.vector();
    problem.model.body.load(t, *load);
    auto const along_axes =
      fem::alongAxes(problem.discretisation.frames(), *problem.model.body.dofs, *load);
    double force[3] = {};
    for (std::size_t i = 0; i < along_axes.size(); ++i) {
      force[i % 3] += along_axes[i];
    }
    const double size = 100 * (1 + t) * 4; // traction, area
    EXPECT_NEAR(force[0], 0.6 * size, 1e-11 * size);
    EXPECT_NEAR(force[1], 0, 1e-11 * size);
    EXPECT_NEAR(force[2], 0.8 * size, 1e-11 * size);
  }
}

TEST(Solid, BalancesTheTractionAlongTheInitialVelocity)
{
  const double V = 1e-5;
  const auto deck = halfSpace([V](ParameterList& given) {
    given.sublist("Friction").set("Shear Traction", steadyStress(V));
    given.sublist("Friction").set("Slip Direction", array<double>({0.6, 0, 0.8}));
    auto& initial = given.sublist("Initial State");
    initial.set("Velocity X", 0.6 * V / 2).set("Velocity Z", 0.8 * V / 2);
    initial.set("State", "Stress Balance");
  });
  auto const problem = makeProblem<3>(deck, world());
  for (double alpha : valuesOf(problem.model.initial.alpha)) {
    EXPECT_NEAR(alpha, std::log(1e-6 / V), 1e-9) << "steady state";
  }
  for (double rate : onFault(problem, "slip_rate")) {
    EXPECT_NEAR(rate, V, 1e-12 * V);
  }
  const auto velocity = onFault(problem, "slip_velocity");
  ASSERT_EQ(velocity.size(), 3 * problem.surface().numNodes());
  for (std::size_t i = 0; i < velocity.size(); i += 3) {
    EXPECT_NEAR(velocity[i], 0.6 * V, 1e-12 * V);
    EXPECT_EQ(velocity[i + 1], 0);
    EXPECT_NEAR(velocity[i + 2], 0.8 * V, 1e-12 * V);
  }
}

TEST(Solid, SlipsAsPrescribedBesideTheFault)
{
  const auto deck = halfSpace([](ParameterList& given) {
    given.sublist("Mesh").sublist("Boundaries").set("deep", "y < 1e-9 && x > 1");
    auto& deep = given.sublist("Boundary Conditions").sublist("Deep");
    deep.set("Boundary", "deep").set("Type", "Prescribed Slip Rate").set("Slip Rate", 2e-9);
    deep.set("Direction", array<double>({0, 5, 2}));
  });
  auto const problem = makeProblem<3>(deck, world());
  auto const v = problem.model.body.vector();
  problem.model.body.prescribed_velocity(0, *v);
  auto const along_axes =
    fem::alongAxes(problem.discretisation.frames(), *problem.model.body.dofs, *v);
  for (int node = 0; node < problem.mesh().num_owned; ++node) {
    auto const& x = problem.mesh().vertices[node];
    const bool is_deep = x[1] == 0 && x[0] >= 1;
    EXPECT_NEAR(along_axes[3 * node + 2], is_deep ? 1e-9 : 0, 1e-22);
    EXPECT_NEAR(along_axes[3 * node], 0, 1e-22);
    EXPECT_EQ(problem.model.body.held[problem.model.body.dofs->dof(node, 0)], is_deep);
  }
}

TEST(Solid, AndThePlaneNeedTheirModels)
{
  const auto plane =
    block([](ParameterList& deck) { deck.sublist("Bulk").set("Model", "Plane Strain"); });
  expectRefusal([&] { makeProblem<3>(plane, world()); },
                {"Bulk / Model = Plane Strain", "3 dimensions", "Solid"});
  const auto solid =
    column([](ParameterList& deck) { deck.sublist("Bulk").set("Model", "Solid"); });
  expectRefusal([&] { makeProblem<2>(solid, world()); },
                {"Bulk / Model = Solid", "2 dimensions", "Plane Strain"});
}

TEST(Solid, HasAShearTractionAlongItsFault)
{
  const auto across = halfSpace([](ParameterList& deck) {
    deck.sublist("Friction").set("Slip Direction", array<double>({0, 1, 0}));
  });
  expectRefusal([&] { makeProblem<3>(across, world()); },
                {"Friction / Slip Direction", "right angles"});
}
} // namespace asperity::scenario
