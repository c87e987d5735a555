#pragma once

#include "dynamics/control/AdaptiveSettings.hpp"
#include "dynamics/control/StepControl.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace asperity::dynamics::test
{
inline const DyadicTime half_seconds(0.5, 16);

inline CouplingSettings coupling(double tolerance, int max_iterations)
{
  CouplingSettings settings;
  settings.tolerance = tolerance;
  settings.max_iterations = max_iterations;
  return settings;
}

// States that are kept outside the archive.
class StatesInMemory : public StateArchive
{
public:
  void save(Archive& archive, std::string const& path, State const& state) const override
  {
    archive.set(path + "/time", state.time);
    states_[path] = state.clone();
  }
  State load(Archive const&, std::string const& path) const override
  {
    return states_.at(path).clone();
  }

private:
  mutable std::map<std::string, State> states_;
};

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
  explicit ControlTest(RateUpdate const& update = RateUpdate::newmark(0.25),
                       ModelOptions const& options = slidingBlock(2))
      : model(options, fem::test::selfCommunicator())
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

  // `continued`, with the memory of `control`, takes the same steps from the same state.
  void expectSameContinuation(StepControl& control, State& from, StepControl& continued,
                              int num_steps)
  {
    SolveCount count;
    Archive memory;
    control.save(memory, states);
    continued.restore(memory, states);
    auto copy = from.clone();
    for (int n = 0; n < num_steps; ++n) {
      auto const expected = control.advance(from, count);
      auto const accepted = continued.advance(copy, count);
      EXPECT_EQ(accepted.level, expected.level);
      EXPECT_EQ(accepted.iterations, expected.iterations);
      EXPECT_EQ(accepted.error, expected.error);
      EXPECT_EQ(copy.time, from.time);
      EXPECT_EQ(denseOf(*copy.v), denseOf(*from.v));
      EXPECT_EQ(denseOf(copy.alpha), denseOf(from.alpha));
    }
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

  // Times of the steps that `control`, made with these instants, takes up to the last of them.
  std::vector<DyadicTime::Ticks> timesUpTo(StepControl& control,
                                           std::vector<DyadicTime::Ticks> const& instants)
  {
    SolveCount count;
    std::vector<DyadicTime::Ticks> times;
    while (state.time < instants.back()) {
      auto const before = state.time;
      auto const accepted = control.advance(state, count);
      EXPECT_EQ(state.time - before, half_seconds.ticks(accepted.level));
      EXPECT_TRUE(accepted.within_tolerance);
      times.push_back(state.time);
    }
    return times;
  }

  inline static const DyadicTime::Ticks large = half_seconds.ticks(8);
  inline static const std::vector<DyadicTime::Ticks> several_instants = {
    20 * large + 173, 20 * large + 174, 45 * large, 60 * large + 1};
  inline static const std::vector<DyadicTime::Ticks> far_instant = {half_seconds.ticks(0) * 1000};
  inline static const std::vector<DyadicTime::Ticks> near_instant = {10 * large + 173};

  // The context of a control in a run with these instants.
  ControlContext meeting(std::vector<DyadicTime::Ticks> const& instants)
  {
    ControlContext context{stepper.step};
    context.instants = instants;
    return context;
  }

  // For a control that meets several_instants: they are among the times, the last one at their end;
  // steps before an instant descend, and go on afterwards as if nothing had been.
  void expectInstantsMet(StepControl& control)
  {
    auto const& instants = several_instants;
    auto const times = timesUpTo(control, instants);
    for (auto instant : instants) {
      EXPECT_EQ(std::count(times.begin(), times.end(), instant), 1) << instant;
    }
    EXPECT_EQ(times.back(), instants.back());
    auto const at = [&](DyadicTime::Ticks instant) {
      return std::find(times.begin(), times.end(), instant) - times.begin();
    };
    auto const after = at(instants[1]);
    EXPECT_GE(times[after + 1] - times[after], large / 4) << "goes on with the size of before";
    EXPECT_LE(after, 20 * 4 + 16);
  }

  // As long as far_instant, which `control` meets, is not in reach, it changes nothing.
  void expectSameStepsFarFromInstants(StepControl& control, StepControl& free)
  {
    SolveCount count;
    auto other = state.clone();
    for (int n = 0; n < 8; ++n) {
      auto const accepted = control.advance(state, count);
      auto const expected = free.advance(other, count);
      EXPECT_EQ(accepted.level, expected.level);
      EXPECT_EQ(accepted.error, expected.error);
      EXPECT_EQ(denseOf(*state.v), denseOf(*other.v));
    }
  }

  // What a control remembers while it cuts steps short is all that the steps to come depend on.
  // Both meet near_instant.
  void expectContinuationBeforeAnInstant(StepControl& control, StepControl& continued)
  {
    SolveCount count;
    while (control.memory().level_after == ControlMemory::none) {
      control.advance(state, count);
      ASSERT_LT(state.time, near_instant[0]);
    }
    expectSameContinuation(control, state, continued, 12);
    EXPECT_GT(state.time, near_instant[0]);
  }

  Model model;
  Stepper stepper;
  State state;
  StatesInMemory states;
};
} // namespace asperity::dynamics::test
