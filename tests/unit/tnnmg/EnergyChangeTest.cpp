#include "tnnmg/NodalProblem.hpp"

#include <gtest/gtest.h>

namespace asperity::tnnmg
{
TEST(EnergyChange, RisesByMoreThanTheRoundingOfALongSum)
{
  const int count = 1000000;
  double sum = 0; // off by the same sign again and again
  for (int i = 0; i < count; ++i) {
    sum += 0.1;
  }
  const double off = sum - 0.1 * count;
  EXPECT_GT(off, 1e-12 * sum);
  EXPECT_EQ((EnergyChange{off, sum}.countsAsIncrease(count)), 0);
  EXPECT_EQ((EnergyChange{1e-9 * sum, sum}.countsAsIncrease(count)), 1);
  EXPECT_EQ((EnergyChange{1e-14 * sum, sum}.countsAsIncrease(10)), 1);
}
} // namespace asperity::tnnmg
