#include "dynamics/watches/EnergyIncreaseWatch.hpp"

#include "unit/base/Refusal.hpp"

#include <gtest/gtest.h>

namespace asperity::dynamics
{
TEST(EnergyIncreaseWatch, WarnsOfTheFirstAndOfTenTimesAsMany)
{
  EnergyIncreaseWatch watch;
  EXPECT_FALSE(watch.note(0));
  auto const warning = watch.note(2);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->topic, "energy increase");
  // tests/support/asperity_run.py looks for the first words in what every run prints.
  asperity::test::expectParts(
    "WARNING: " + warning->text,
    {"WARNING: J grew 2 times in sweeps or corrections of TNNMG (energy_increases in "
     "steps.csv)"});
  EXPECT_EQ(EnergyIncreaseWatch().note(1)->text.find("J grew once in sweeps"), 0u);
  EXPECT_FALSE(watch.note(19));
  EXPECT_TRUE(watch.note(20));
}
} // namespace asperity::dynamics
