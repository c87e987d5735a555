#include "io/files/TimeLeft.hpp"

#include <gtest/gtest.h>

using asperity::io::TimeLeft;

namespace
{
// A run on a clock of its own.
struct Simulated
{
  // `speed`: of the simulated time per second of wall time.
  void go(double speed, double wall_seconds, int num_steps)
  {
    for (int step = 0; step < num_steps; ++step) {
      fraction += speed * wall_seconds / num_steps;
      seconds += wall_seconds / num_steps;
      left.note(fraction, seconds);
    }
  }
  TimeLeft left;
  double fraction = 0, seconds = 1e5;
};
} // namespace

TEST(TimeLeft, IsUnknownBeforeTheFirstStep)
{
  Simulated run;
  EXPECT_LT(run.left.seconds(), 0);
  run.left.note(0, 1e5);
  EXPECT_LT(run.left.seconds(), 0);
}

TEST(TimeLeft, IsWhatASteadyRunNeeds)
{
  Simulated run;
  run.left.note(0, run.seconds);
  run.go(1e-3, 2, 10);
  EXPECT_NEAR(run.left.seconds(), 998, 1e-6);
  run.go(1e-3, 600, 7);
  EXPECT_NEAR(run.left.seconds(), 398, 1);
}

// Half of it in a minute, then ten minutes for another twentieth: the mean since the start would
// say nine minutes, of a run that needs an hour and a half.
TEST(TimeLeft, FollowsTheRecentSpeed)
{
  Simulated run;
  run.left.note(0, run.seconds);
  run.go(0.5 / 60, 60, 100);
  EXPECT_NEAR(run.left.seconds(), 60, 1);
  run.go(0.05 / 600, 600, 100000);
  const double needed = 0.45 / (0.05 / 600);
  EXPECT_GT(run.left.seconds(), 0.5 * needed);
  EXPECT_LE(run.left.seconds(), needed);
  run.go(0.05 / 600, 1200, 100000);
  EXPECT_NEAR(run.left.seconds(), 0.35 / (0.05 / 600), 0.02 * needed);
}

TEST(TimeLeft, IsTheSameForFewLongAndManyShortSteps)
{
  Simulated few, many;
  for (Simulated* run : {&few, &many}) {
    run->left.note(0, run->seconds);
  }
  few.go(1e-4, 100, 50);
  many.go(1e-4, 100, 5000);
  EXPECT_NEAR(few.left.seconds(), many.left.seconds(), 0.02 * many.left.seconds());
}
