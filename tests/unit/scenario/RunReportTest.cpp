#include "scenario/report/RunReport.hpp"

#include "SampleDeck.hpp"

namespace asperity::scenario
{
using namespace test;

TEST(RunReport, PrintsABalanceThatAddsUp)
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
} // namespace asperity::scenario
