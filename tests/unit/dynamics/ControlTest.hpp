#pragma once

#include "dynamics/control/StepControl.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

namespace asperity::dynamics::testing
{
inline const DyadicTime half_seconds(0.5, 16);

inline CouplingSettings coupling(double tolerance, int max_iterations)
{
  CouplingSettings settings;
  settings.tolerance = tolerance;
  settings.max_iterations = max_iterations;
  return settings;
}

inline AdaptiveSettings adaptive(double tolerance, int first_level, int finest_level = 16)
{
  AdaptiveSettings settings;
  settings.tolerance = tolerance;
  settings.first_level = first_level;
  settings.finest_level = finest_level;
  return settings;
}

// A sliding block, steps of half a second and shorter, and what they should come to.
class ControlTest : public ::testing::Test
{
protected:
  explicit ControlTest(RateUpdate const& update = RateUpdate::newmark(0.25))
      : model(slidingBlock(2), fem::testing::selfCommunicator())
      , stepper(model, update, half_seconds)
      , state(slidingState(model))
  {
  }

  // The state after steps of these levels, made without step control.
  State stepped(State const& from, std::vector<int> const& levels)
  {
    State last = from.clone();
    for (int level : levels) {
      State next = last.clone();
      EXPECT_TRUE(stepper.step.solve(last, level, next, stepper.count).solved());
      last = next;
    }
    return last;
  }

  // How far one step of a level is from two of half its size.
  double errorOf(State const& from, int level, Norm norm = Norm::root_mean_square)
  {
    return dynamics::distance(*model.surface, stepped(from, {level}).alpha,
                              stepped(from, {level + 1, level + 1}).alpha, norm);
  }

  double difference(State const& x, State const& y) const
  {
    return (denseOf(*x.v) - denseOf(*y.v)).norm() / denseOf(*y.v).norm() +
           dynamics::distance(*model.surface, x.alpha, y.alpha);
  }

  // `control`, some of whose steps have no solution, takes smaller ones than `free`, and goes on.
  void expectSmallerSteps(StepControl& control, StepControl& free)
  {
    SolveCount count;
    auto other = state.clone();
    auto const before = state.clone();
    auto const accepted = control.advance(state, count);
    EXPECT_GT(accepted.level, free.advance(other, count).level);
    EXPECT_GT(count.failures, 0);
    EXPECT_EQ(state.time, half_seconds.ticks(accepted.level));
    EXPECT_LE(
      dynamics::distance(*model.surface, state.alpha, stepped(before, {accepted.level}).alpha),
      2e-3);
    for (int n = 0; n < 5; ++n) {
      control.advance(state, count);
    }
  }

  Model model;
  Stepper stepper;
  State state;
};
} // namespace asperity::dynamics::testing
