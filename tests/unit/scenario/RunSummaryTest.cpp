#include "scenario/report/RunSummary.hpp"

#include "SampleDeck.hpp"

#include <limits>

namespace asperity::scenario
{
using namespace test;

TEST(RunSummary, PrintsABalanceThatAddsUp)
{
  RunSummary summary;
  auto& energy = summary.energy;
  energy.boundary_work = 100;
  energy.load_work = 20;
  energy.friction_work = 64;
  energy.viscous_work = 8;
  energy.numerical_dissipation = 2;
  energy.defect = 0.5;
  // What a restart leaves of them says nothing about their change since the start.
  energy.kinetic = 1000;
  energy.elastic = 2000;
  expectParts(summarise(summary, "12 events\n"),
              {"\n12 events\n", "boundaries 100 and loads 20",
               "friction 64, viscosity 8 and the time stepping 2",
               "change of kinetic and elastic energy 46.5",
               "defect of the balance of 0.5 (0.0078"});
}

TEST(RunSummary, CountsOneStepAsOne)
{
  RunSummary summary;
  summary.num_steps = 1;
  summary.forced_steps = 1;
  summary.count.coupled_steps = 3;
  summary.count.rate_problems = 1;
  expectParts(summarise(summary, ""),
              {"after 1 step.", "3 coupled steps (0 failed), 1 rate problem, 0 TNNMG iterations",
               "1 step of the smallest size was accepted"});
}

TEST(RunSummary, WarnsOfABalanceThatDoesNotClose)
{
  const auto warns = [](double defect, double elastic = 1) {
    dynamics::Energy energy{};
    energy.friction_work = 1;
    energy.elastic = elastic;
    energy.defect = defect;
    return warnOfDefect(energy).has_value();
  };
  EXPECT_TRUE(warns(-2e-3));
  EXPECT_FALSE(warns(5e-4));
  EXPECT_FALSE(warns(2e-3, 1e7)); // rounding
  EXPECT_TRUE(warns(std::numeric_limits<double>::quiet_NaN()));
}
} // namespace asperity::scenario
