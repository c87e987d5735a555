#include "dynamics/DyadicTime.hpp"

#include <gtest/gtest.h>

namespace asperity::dynamics
{
TEST(DyadicTime, HalvesTheStepFromLevelToLevel)
{
  const DyadicTime clock(0.1, 40);
  for (int level = 0; level < 40; ++level) {
    EXPECT_EQ(clock.stepSize(level), 2 * clock.stepSize(level + 1));
    EXPECT_EQ(clock.ticks(level), 2 * clock.ticks(level + 1));
  }
  EXPECT_EQ(clock.stepSize(0), 0.1);
  EXPECT_EQ(clock.ticks(40), 1);
}

TEST(DyadicTime, AddsCenturiesAndMillisecondsWithoutLoss)
{
  const double century = 3.15576e9;    // s
  const DyadicTime clock(century, 60); // the smallest step is 2.7 ns
  const int millisecond = 42;          // 0.72 ms
  DyadicTime::Ticks time = 3 * clock.ticks(0);
  for (int n = 0; n < 1000; ++n) {
    time += clock.ticks(millisecond);
  }
  for (int n = 0; n < 1000; ++n) {
    time -= clock.ticks(millisecond);
  }
  EXPECT_EQ(time, 3 * clock.ticks(0));
  EXPECT_EQ(clock.seconds(time), 3 * century);
}

TEST(DyadicTime, SumsOfStepsAreExactInSeconds)
{
  const DyadicTime clock(0.3, 20);
  DyadicTime::Ticks time = 0;
  for (int level = 0; level <= 20; ++level) {
    time += clock.ticks(level);
  }
  EXPECT_EQ(clock.seconds(time), 0.3 * (2 - std::ldexp(1., -20)));
  EXPECT_EQ(clock.seconds(clock.ticks(7)), clock.stepSize(7));
}

TEST(DyadicTime, FindsTheLargestStepWithin)
{
  const DyadicTime clock(0.5, 10);
  EXPECT_EQ(clock.levelWithin(DyadicTime::Ticks(1) << 62), 0);
  EXPECT_EQ(clock.levelWithin(1024), 0);
  EXPECT_EQ(clock.levelWithin(1023), 1);
  EXPECT_EQ(clock.levelWithin(3), 9);
  EXPECT_EQ(clock.levelWithin(1), 10);
}

TEST(DyadicTime, TakesNoTickForRounding)
{
  EXPECT_EQ(DyadicTime(0.1, 20).reaching(1.1), DyadicTime::Ticks(11) << 20);
  EXPECT_EQ(DyadicTime(0.1, 20).reaching(1.1 + 1e-7), (DyadicTime::Ticks(11) << 20) + 2);
}

TEST(DyadicTime, ReachesATimeWithTheFirstTickNotBeforeIt)
{
  const DyadicTime clock(1, 3);
  EXPECT_EQ(clock.reaching(2), 16);
  EXPECT_EQ(clock.reaching(2.01), 17);
  EXPECT_EQ(clock.reaching(1.99), 16);
  EXPECT_EQ(clock.reaching(0), 0);
  EXPECT_TRUE(clock.reaches(1e18));
  EXPECT_FALSE(clock.reaches(1.2e18));
}
} // namespace asperity::dynamics
