#include "io/files/TimeLeft.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

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
      left.note(fraction, seconds, num_events);
    }
  }
  double secondsLeft() const { return left.estimate(1).value().seconds; }
  bool knowsCycles() const
  {
    auto const estimate = left.estimate(1);
    return estimate && estimate->knows_cycles;
  }

  TimeLeft left;
  double fraction = 0, seconds = 1e5;
  std::int64_t num_events = 0;
};

constexpr int num_cycles = 20;

// Almost all of a cycle's time in a sixth of the wall time that it takes, the rest in an event, in
// the middle of which `aftershocks` begin. Calls check(seconds left in truth, cycles done) after
// every step.
template <class Check>
void goThroughCycles(Simulated& run, double spread, Check const& check, int aftershocks = 0)
{
  const auto calm = [=](int k) { return 100 * (1 + spread * std::cos(2.5 * k)); };
  const auto event = [=](int k) { return 500 * (1 + spread * std::sin(1.7 * k)); };
  double truth = 0;
  for (int k = 0; k < num_cycles; ++k) {
    truth += calm(k) + event(k);
  }
  run.left.note(0, run.seconds, 0);
  const auto go = [&](double share, double wall_seconds, int cycles_done) {
    for (int step = 0; step < 50; ++step) {
      run.go(share / num_cycles / wall_seconds, wall_seconds / 50, 1);
      truth -= wall_seconds / 50;
      check(truth, cycles_done);
    }
  };
  for (int k = 0; k < num_cycles; ++k) {
    go(0.999, calm(k), k);
    ++run.num_events;
    go(0.0005, event(k) / 2, k);
    run.num_events += aftershocks;
    go(0.0005, event(k) / 2, k);
  }
}
} // namespace

TEST(TimeLeft, IsUnknownBeforeTheFirstStep)
{
  Simulated run;
  EXPECT_FALSE(run.left.estimate(1));
  run.left.note(0, 1e5);
  EXPECT_FALSE(run.left.estimate(1));
}

TEST(TimeLeft, IsWhatASteadyRunNeeds)
{
  Simulated run;
  run.left.note(0, run.seconds);
  run.go(1e-3, 2, 10);
  EXPECT_NEAR(run.secondsLeft(), 998, 1e-6);
  run.go(1e-3, 600, 7);
  EXPECT_NEAR(run.secondsLeft(), 398, 1);
}

// Half of it in a minute, then ten minutes for another twentieth: the mean since the start would
// say nine minutes, of a run that needs an hour and a half.
TEST(TimeLeft, FollowsTheRecentSpeed)
{
  Simulated run;
  run.left.note(0, run.seconds);
  run.go(0.5 / 60, 60, 100);
  EXPECT_NEAR(run.secondsLeft(), 60, 1);
  run.go(0.05 / 600, 600, 100000);
  const double needed = 0.45 / (0.05 / 600);
  EXPECT_NEAR(run.secondsLeft(), needed, 1e-6 * needed);
}

TEST(TimeLeft, IsTheSameForFewLongAndManyShortSteps)
{
  Simulated few, many;
  for (Simulated* run : {&few, &many}) {
    run->left.note(0, run->seconds);
  }
  few.go(1e-4, 100, 50);
  many.go(1e-4, 100, 5000);
  EXPECT_NEAR(few.secondsLeft(), many.secondsLeft(), 0.02 * many.secondsLeft());
}

// The recent speed would say half an hour before an event and months in it.
TEST(TimeLeft, KnowsWhatPastCyclesTook)
{
  Simulated run;
  int known = 0;
  goThroughCycles(run, 0, [&](double truth, int cycles_done) {
    if (cycles_done >= 2) {
      ++known;
      EXPECT_TRUE(run.knowsCycles());
      EXPECT_NEAR(run.secondsLeft(), truth, 0.02 * 600) << "cycle " << cycles_done;
    }
  });
  EXPECT_EQ(known, (num_cycles - 2) * 150);
  run.left.note(1, run.seconds, num_cycles);
  EXPECT_EQ(run.secondsLeft(), 0);
}

// The first aftershock alone would make a cycle of half an event, and years of the time left.
TEST(TimeLeft, TakesAftershocksForPartsOfTheirCycle)
{
  Simulated run;
  const auto check = [&](double truth, int cycles_done) {
    EXPECT_EQ(run.knowsCycles(), run.num_events > 2) << run.num_events;
    if (cycles_done >= 2) {
      EXPECT_NEAR(run.secondsLeft(), truth, 0.02 * 600) << "cycle " << cycles_done;
    }
  };
  goThroughCycles(run, 0, check, 1);
}

TEST(TimeLeft, IsWithinACycleOrAFifthWhereCyclesDiffer)
{
  Simulated run;
  goThroughCycles(run, 0.3, [&](double truth, int cycles_done) {
    if (cycles_done >= 4) {
      EXPECT_NEAR(run.secondsLeft(), truth, std::max(600.0, 0.2 * truth)) << cycles_done;
      EXPECT_GE(run.secondsLeft(), 0);
    }
  });
}

// The speed in the first event would say centuries, also to a run that is restarted there.
TEST(TimeLeft, IsUnknownInTheFirstEvent)
{
  Simulated run;
  run.left.note(0, run.seconds);
  run.go(0.5 / 60, 60, 100);
  EXPECT_NEAR(run.secondsLeft(), 60, 1);
  ++run.num_events;
  run.go(1e-9, 200, 100);
  EXPECT_FALSE(run.left.estimate(1));
  asperity::Archive archive;
  run.left.save(archive);
  TimeLeft restarted;
  restarted.restore(archive);
  EXPECT_FALSE(restarted.estimate(1));
  run.go(0.2 / 60, 60, 100);
  EXPECT_TRUE(run.left.estimate(1));
}

TEST(TimeLeft, DoesNotKnowCyclesBeforeTwoEvents)
{
  Simulated run;
  goThroughCycles(run, 0, [&](double, int) {
    if (run.num_events < 2) {
      EXPECT_FALSE(run.knowsCycles());
    }
  });
  EXPECT_TRUE(run.knowsCycles());
}

// A run that was restarted has events that it did not see.
TEST(TimeLeft, CountsOnlyTheCyclesThatItSaw)
{
  Simulated run;
  run.num_events = 7;
  run.left.note(0.3, run.seconds, run.num_events);
  run.fraction = 0.3;
  run.go(1e-3, 10, 10);
  EXPECT_FALSE(run.knowsCycles());
  EXPECT_NEAR(run.secondsLeft(), 690, 1);
}

TEST(TimeLeft, KnowsAfterARestartWhatItKnewAtTheCheckpoint)
{
  Simulated run;
  goThroughCycles(run, 0.3, [&](double, int cycles_done) {
    if (cycles_done > 0) {
      asperity::Archive archive;
      run.left.save(archive);
      TimeLeft restarted;
      restarted.restore(archive);
      EXPECT_EQ(restarted.estimate(1).value().seconds, run.secondsLeft());
      EXPECT_EQ(restarted.estimate(1).value().knows_cycles, run.knowsCycles());
    }
  });
  EXPECT_TRUE(run.knowsCycles());
}
