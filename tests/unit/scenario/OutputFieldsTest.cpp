#include "scenario/fields/OutputFields.hpp"

#include "SampleDeck.hpp"
#include "catalogue/stress/CoulombPlanes.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

namespace asperity::scenario
{
using namespace test;

namespace
{
// What outputs see of a problem at its start. The fault's nodes are at x = 0, 1, 2.
struct Start
{
  explicit Start(ParameterList const& given)
      : deck(given)
      , problem(makeProblem<2>(deck, world()))
      , balance(problem.model.body, problem.model.fault, makeClock(problem.settings.time))
      , sample(problem.surface(), *problem.model.initial.u)
      , domains(makeDomains(problem))
  {
    balance.start(problem.model.initial);
    view.state = &problem.model.initial;
    sample.begin(problem.model.initial, 0, balance);
    view.fault = &sample;
    view.balance = &balance;
    registerFields(registry, problem, view, domains,
                   catalogue::coulombPlanes(deck.sublist("Output"), 2));
  }

  std::vector<double> onFault(std::string const& name) const
  {
    std::vector<double> values;
    registry.field("fault", name).values(values);
    return values;
  }

  ParameterList deck;
  Problem<2> problem;
  dynamics::EnergyBalance balance;
  dynamics::FaultSample sample;
  std::map<std::string, io::OutputDomain> domains;
  RunView view;
  io::FieldRegistry registry;
};
} // namespace

TEST(OutputFields, ThetaIsOfTheNodesOwnSlipDistanceAndReferenceRate)
{
  const Start start(column([](auto& deck) {
    deck.sublist("Friction").set("L", "0.02 * (1 + x)").set("Reference Slip Rate", 1e-5);
    deck.sublist("Initial State").set("alpha", "3 - x");
  }));
  expectNear(start.onFault("theta"), {2e3 * std::exp(3), 4e3 * std::exp(2), 6e3 * std::exp(1)});
}

TEST(OutputFields, NoThetaWhereTheStateLawDoesNotSayHowItFollows)
{
  const Start start(column([](auto& deck) {
    deck.sublist("Friction").set("State Evolution", "Slow Ageing"); // in DeckReaderTest.cpp
  }));
  EXPECT_EQ(start.onFault("alpha").size(), 3u);
  expectRefusal([&] { start.onFault("theta"); }, {"theta"});
}

TEST(OutputFields, AlphaIsTheStateVariableOfTheLaw)
{
  const auto described = [](ParameterList const& deck) {
    return Start(deck).registry.field("fault", "alpha").description;
  };
  EXPECT_EQ(described(column()), "State: ln(theta V* / L).");
  EXPECT_EQ(described(column([](auto& deck) {
              auto& friction = deck.sublist("Friction");
              for (auto const* name :
                   {"a", "b", "L", "Reference Slip Rate", "Reference Friction Coefficient"}) {
                friction.remove(name, false);
              }
              friction.set("Law", "Slip Weakening").set("State Evolution", "Slip Weakening");
              friction.set("Static Friction Coefficient", 0.7);
              friction.set("Dynamic Friction Coefficient", 0.5);
              friction.set("Slip-Weakening Distance", 0.9);
            })),
            "State: share of slip weakening.");
}

TEST(OutputFields, ShearModulusIsThatOfTheBodyBesideTheFault)
{
  const Start start(
    column([](auto& deck) { deck.sublist("Bulk").set("Shear Modulus", "if(y < 1, 1e6, 7e6)"); }));
  expectNear(start.onFault("shear_modulus"), {1e6, 1e6, 1e6});
}

TEST(OutputFields, WhereTheSlipRateIsPrescribed)
{
  const Start start(column());
  EXPECT_EQ(start.onFault("prescribed"), (std::vector<double>{1, 0, 1})) << "the walls";
}

TEST(OutputFields, TheEnergiesOfTheBalanceAreScalars)
{
  const Start start(column());
  const auto names = start.registry.scalarNames();
  for (char const* name :
       {"kinetic_energy", "elastic_energy", "load_work", "boundary_work", "friction_work",
        "viscous_work", "numerical_dissipation", "energy_defect"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
  EXPECT_GT(start.registry.scalar("elastic_energy").value(), 0); // under its weight
}
} // namespace asperity::scenario
