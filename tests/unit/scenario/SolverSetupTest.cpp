#include "scenario/setup/SolverSetup.hpp"

#include "SampleDeck.hpp"
#include "scenario/setup/TimeSchemes.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <limits>
#include <set>
#include <string>

namespace asperity::scenario
{
using namespace test;
using dynamics::Correction;

namespace
{
TimeSettings timeSettings(std::function<void(ParameterList&)> const& change)
{
  return TimeSettings::from(completeDeck([&](ParameterList& deck) {
                              change(deck.sublist("Time Stepping"));
                            }).sublist("Time Stepping"));
}

TimeSettings steps(double largest, double smallest, double end = 10)
{
  return timeSettings([&](ParameterList& list) {
    list.set("Largest Step", largest).set("Smallest Step", smallest).set("Final Time", end);
  });
}

TimeSettings beta(double value, double limit = 0)
{
  return timeSettings([&](ParameterList& list) {
    list.sublist("Newmark").set("beta", value).set("Stability Limit", limit);
  });
}

ParameterList solverList(std::string const& correction)
{
  return completeDeck(
           [&](ParameterList& deck) { deck.sublist("TNNMG").set("Linear Correction", correction); })
    .sublist("TNNMG");
}
} // namespace

TEST(TimeSetup, DividesTheLargestStepByPowersOfTwo)
{
  const auto clock = makeClock(steps(4, 1e-7));
  EXPECT_EQ(clock.stepSize(0), 4);
  EXPECT_LE(clock.stepSize(clock.finestLevel()), 1e-7);
  EXPECT_GT(clock.stepSize(clock.finestLevel() - 1), 1e-7);
  EXPECT_EQ(makeClock(steps(4, 4)).finestLevel(), 0);
  EXPECT_EQ(makeClock(steps(0.3, 0.3 / 1024)).finestLevel(), 10) << "an exact fraction";
}

TEST(TimeSetup, RefusesStepsThatCannotBeCounted)
{
  expectRefusal([] { makeClock(steps(1, 2)); },
                {"Asperity / Time Stepping / Smallest Step = 2", "larger than the largest"});
  expectRefusal([] { makeClock(steps(1, 1e-20)); }, {"Smallest Step = 1e-20", "2^60"});
  expectRefusal([] { makeClock(steps(1, 1e-12, 1e8)); },
                {"Asperity / Time Stepping / Final Time = 1e+08", "Choose at most 4.09e+06 s",
                 "'Smallest Step'", "Most Events"});
  expectRefusal([] { steps(1, 0); }, {"Smallest Step = 0 is outside (0, inf)"});
  expectRefusal([] { steps(-1, 1); }, {"Largest Step = -1 is outside (0, inf)"});
  expectRefusal([] { steps(1, 1, 0); }, {"Final Time = 0 is outside (0, inf)"});
}

// The default of the smallest step does not follow from the length of the run, and what the deck
// does not have is not what should change.
TEST(TimeSetup, RefusesAFinalTimeByItsNameWhereTheSmallestStepIsADefault)
{
  const auto of_default = [](double largest, double end) {
    return timeSettings([&](ParameterList& list) {
      list.set("Largest Step", largest).set("Final Time", end).remove("Smallest Step");
    });
  };
  const double tick = 0x1p-24;
  for (const double end : {3e11, 1e15, 1e300}) {
    auto const text = refusal([&] { makeClock(of_default(1, end), tick); });
    expectParts(text, {"Final Time", "Choose at most 2.68e+11 s."});
    EXPECT_EQ(text.find("'Smallest Step'"), std::string::npos) << text;
  }
  EXPECT_EQ(makeClock(of_default(1, 2.68e11), tick).finestLevel(), 24);
  expectRefusal([&] { makeClock(of_default(1e300, 1), tick); },
                {"Largest Step = 1e+300", "2^60", "Choose a smaller one."});
}

TEST(TimeSetup, LeavesOutInstantsAfterTheEnd)
{
  const auto settings = timeSettings([](ParameterList& given) {
    given.set("Largest Step", 1.).set("Smallest Step", 0.5).set("Final Time", 10.);
    given.set("Instants", array<double>({1e300, 4., 10.}));
  });
  EXPECT_EQ(instants(settings, {2, 11, 0}, makeClock(settings)),
            (std::vector<dynamics::DyadicTime::Ticks>{4, 8, 20}));
}

TEST(TimeSetup, ChoosesTheScheme)
{
  const auto newmark = makeRateUpdate(beta(0.3));
  EXPECT_EQ(newmark.name, "Newmark");
  EXPECT_EQ(newmark.mass_weight, 2);
  EXPECT_NEAR(newmark.stiffness_weight, 0.6, 1e-15);
  const auto euler =
    makeRateUpdate(timeSettings([](auto& list) { list.set("Scheme", "Backward Euler"); }));
  EXPECT_EQ(euler.mass_weight, 1);
  EXPECT_EQ(euler.stiffness_weight, 1);
}

// A row of the table is all that a scheme needs: each is chosen by its name, and makes its own.
TEST(TimeSetup, MakesEachSchemeThatADeckCanName)
{
  std::set<std::string> made;
  for (auto const& scheme : timeSchemes()) {
    const auto settings = timeSettings([&](auto& list) { list.set("Scheme", scheme.name); });
    EXPECT_EQ(settings.scheme, scheme.name);
    EXPECT_FALSE(scheme.meaning.empty()) << scheme.name;
    made.insert(makeRateUpdate(settings).name);
  }
  EXPECT_EQ(made.size(), timeSchemes().size());
  EXPECT_EQ(made.count(massless_scheme), 1u);
}

TEST(TimeSetup, WantsALimitWhereNewmarkIsConditionallyStable)
{
  expectRefusal([] { makeRateUpdate(beta(0.2)); },
                {"Asperity / Time Stepping / Newmark / beta = 0.2", "'Stability Limit'", "0.25"});
  expectRefusal([] { makeRateUpdate(beta(0.2, 0.5)); },
                {"Largest Step = 1", "stability limit of 0.5 s", "beta = 0.2"});
  EXPECT_NEAR(makeRateUpdate(beta(0.2, 1)).stiffness_weight, 0.4, 1e-15);
  for (double outside : {-0.1, 0.51}) {
    expectRefusal([&] { beta(outside); }, {"Newmark / beta", "[0, 0.5]"});
  }
}

TEST(SolverSetup, ChoosesTheCorrection)
{
  const auto choice = [](std::string const& name, int ranks, long long unknowns,
                         int dimension = 2) {
    return makeSolverSettings(SolverSettings::from(solverList(name)), ranks, dimension, unknowns)
      .correction;
  };
  EXPECT_EQ(choice("Auto", 1, 10000), Correction::direct);
  EXPECT_EQ(choice("Auto", 1, 10000000), Correction::multigrid);
  EXPECT_EQ(choice("Auto", 2, 10000), Correction::multigrid);
  EXPECT_EQ(choice("Auto", 1, 50000, 2), Correction::direct);
  EXPECT_EQ(choice("Auto", 1, 50000, 3), Correction::multigrid);
  EXPECT_EQ(choice("Direct", 1, 10000000), Correction::direct);
  EXPECT_EQ(choice("Multigrid", 1, 10), Correction::multigrid);
  expectRefusal([&] { choice("Direct", 2, 10); },
                {"Asperity / TNNMG / Linear Correction = Direct", "not on 2", "Multigrid"});
}

TEST(SolverSetup, ReadsTolerancesAndBudget)
{
  auto list = solverList("Auto");
  list.set("Absolute Tolerance", 3e-7).set("Maximum Iterations", 4).set("Memory Budget", 12.5);
  const auto settings = makeSolverSettings(SolverSettings::from(list), 1, 2, 10);
  EXPECT_EQ(settings.tnnmg.absolute_tolerance, 3e-7);
  EXPECT_EQ(settings.tnnmg.max_iterations, 4);
  EXPECT_EQ(SolverSettings::from(list).memoryBudget(), 12500000U);
  for (const double no_limit : {2e13, 1e308}) {
    list.set("Memory Budget", no_limit);
    EXPECT_EQ(SolverSettings::from(list).memoryBudget(), std::numeric_limits<std::size_t>::max());
  }
}

TEST(SolverSetup, SaysWhatDirectCostsWhereAutoChoosesMultigrid)
{
  const auto hint_on = [](std::string const& correction, int dimension, long long num_unknowns) {
    return hintOnDirect(SolverSettings::from(solverList(correction)), dimension, num_unknowns);
  };
  const auto hint = hint_on("Direct", 3, 45000);
  for (char const* piece :
       {"Linear Correction = Direct", "45000 unknowns", "set-up of step sizes"}) {
    expectParts(hint, {piece});
  }
  EXPECT_EQ(hint_on("Direct", 3, 9000), "");
  EXPECT_EQ(hint_on("Direct", 2, 45000), "");
  EXPECT_EQ(hint_on("Multigrid", 3, 45000), "");
  EXPECT_EQ(hint_on("Auto", 3, 45000), "");
}
} // namespace asperity::scenario
