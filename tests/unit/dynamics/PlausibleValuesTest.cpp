#include "dynamics/checks/PlausibleValues.hpp"

#include "unit/base/Refusal.hpp"

#include <gtest/gtest.h>

namespace asperity::dynamics
{
namespace
{
// Rock whose speed of shear waves has these extremes.
BesideFault beside(Extremes const& speed)
{
  BesideFault values;
  values.shear_speed = speed;
  values.pressure_speed = {6000, 6000};
  values.normal_stress = {1e6, 5e7};
  return values;
}
} // namespace

TEST(PlausibleValues, ValuesThatDifferByRoundingAreOneNumber)
{
  const double speed = 10000. / 3;
  asperity::test::expectParts(
    describeSpeeds(beside({speed, speed * (1 + 1e-15)})),
    {"c_s = 3333.33 m/s,", "c_p = 6000 m/s", "at the start: 1e+06 to 5e+07 Pa."});
}

TEST(PlausibleValues, SlipRatesAreBelowATenthOfTheFastestShearWave)
{
  const double largest = largestSlipRate(beside({2000, 3464}));
  EXPECT_DOUBLE_EQ(largest, 346.4);
  const auto warning = warnOfSlipRate(2300, largest);
  EXPECT_EQ(warning.topic, "slip rate");
  asperity::test::expectParts(warning.text, {"has reached 2300 m/s", "beside the fault, 3464 m/s"});
}

TEST(PlausibleValues, TwoValuesAreAnInterval)
{
  asperity::test::expectParts(describeSpeeds(beside({2000, 3464})), {"c_s = 2000 to 3464 m/s,"});
}
} // namespace asperity::dynamics
