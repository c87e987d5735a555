#include "dynamics/control/RichardsonControl.hpp"

#include "unit/base/Refusal.hpp"
#include "unit/dynamics/ControlTest.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
class RichardsonControlTest : public ControlTest
{
protected:
  RichardsonControl control(AdaptiveSettings const& settings,
                            std::vector<DyadicTime::Ticks> const& instants = {})
  {
    return {meeting(instants), settings};
  }

  SolveCount count;
};

// A free block, light, that friction can just bear: 0.1 mm/s, and the state is three times that of
// steady sliding, so that it runs away within L / V = 0.25 s. In longer steps it has done so, and a
// step of some milliseconds is long enough for that as a second solution.
ModelOptions blockThatRunsAway()
{
  ModelOptions options;
  options.mesh = fem::test::uniformRectangle(2, 1, 0.2, 0.1);
  options.material.density = 9;
  return options;
}
constexpr double runaway_rate = 1e-4; // m/s

class RunawayRichardsonTest : public ControlTest
{
protected:
  RunawayRichardsonTest() : ControlTest(RateUpdate::newmark(0.25), optionsInBalance())
  {
    model.setFree(*state.v, [](Point<2> const&) -> Point<2> { return {runaway_rate, 0}; });
    state.alpha = model.nodeView([](Point<2> const&) { return alpha(); });
    Kokkos::deep_copy(state.alpha_of_rate, state.alpha);
  }

private:
  static double logOfRate() { return std::log(runaway_rate / ModelOptions().reference_rate); }
  static double alpha() { return std::log(3.) - logOfRate(); }
  static ModelOptions optionsInBalance()
  {
    auto options = blockThatRunsAway();
    options.traction = options.sigma_n *
                       (options.reference_friction + options.a * logOfRate() + options.b * alpha());
    return options;
  }
};

class FirstOrderRichardsonTest : public ControlTest
{
protected:
  FirstOrderRichardsonTest() : ControlTest(RateUpdate::backwardEuler()) {}
};
} // namespace

TEST_F(RichardsonControlTest, AcceptsPairsOfStepsThatOneStepConfirms)
{
  const double tolerance = 1e-4;
  auto control = this->control(adaptive(tolerance, 8));
  int coarsest = 16, finest = 0;
  for (int n = 0; n < 15; ++n) {
    auto const before = state.clone();
    const int predicted = control.memory().level;
    const double last_error = control.lastPair().error;
    auto const first = control.advance(state, count);
    const int level = first.level;
    coarsest = std::min(coarsest, level);
    finest = std::max(finest, level);
    EXPECT_EQ(control.memory().num_steps, 2 * n + 1);
    EXPECT_EQ(state.time, before.time + half_seconds.ticks(level));
    EXPECT_LE(difference(state, stepped(before, {level})), 1e-10);

    auto const second = control.advance(state, count);
    EXPECT_EQ(second.level, level);
    EXPECT_EQ(control.memory().num_steps, 2 * n + 2);
    EXPECT_EQ(state.time, before.time + 2 * half_seconds.ticks(level));
    EXPECT_LE(difference(state, stepped(before, {level, level})), 1e-10);

    ASSERT_GT(level, 0);
    EXPECT_NEAR(first.error, errorOf(before, level - 1) / 3, 1e-10);
    EXPECT_EQ(second.error, first.error);
    EXPECT_LE(first.error, tolerance);
    EXPECT_TRUE(first.within_tolerance);
    EXPECT_TRUE(second.within_tolerance);

    // What the next prediction is made from; the older error as if the steps had been equal.
    EXPECT_EQ(control.lastPair().previous_error, std::ldexp(last_error, 3 * (predicted - level)));
    EXPECT_EQ(control.lastPair().before->time, before.time);
    EXPECT_EQ(control.lastPair().level, level);
  }
  EXPECT_GE(finest - coarsest, 2) << "the run was meant to need several step sizes";
}

// Three coupled steps for each pair, and two more for each halving: the first half of a pair that
// was refused is what the next, smaller pair is compared with.
TEST_F(RichardsonControlTest, TakesThreeCoupledStepsForTwoAndTwoMoreForEachHalving)
{
  auto control = this->control(adaptive(1e-4, 4));
  int num_straight = 0, num_halved = 0;
  for (int n = 0; n < 25; ++n) {
    const int predicted = control.memory().level;
    auto const before = count;
    const int level = control.advance(state, count).level;
    EXPECT_EQ(count.since(before).coupled_steps, 3 + 2 * (level - predicted));
    ++(level == predicted ? num_straight : num_halved);
    auto const between = count;
    control.advance(state, count);
    EXPECT_EQ(count.since(between).coupled_steps, 0);
  }
  EXPECT_EQ(count.failures, 0);
  EXPECT_GT(num_straight, num_halved);
  EXPECT_GT(num_halved, 0) << "the first step was meant to be too large";
}

TEST_F(RichardsonControlTest, TakesAFirstStepThatIsFineEnough)
{
  auto control = this->control(adaptive(1e-4, 12));
  auto const before = state.clone();
  auto const accepted = control.advance(state, count);
  EXPECT_EQ(accepted.level, 12);
  EXPECT_EQ(count.coupled_steps, 3);
  EXPECT_NEAR(accepted.error / (errorOf(before, 11) / 3), 1, 1e-3);
}

TEST_F(RichardsonControlTest, HalvesUntilThePairIsFineEnough)
{
  const double tolerance = 1e-4;
  auto control = this->control(adaptive(tolerance, 2));
  Archive memory;
  control.save(memory, states);
  memory.set("level", 2);
  memory.set("error", 0.5); // of a pair before
  control.restore(memory, states);
  auto const before = state.clone();
  const int level = control.advance(state, count).level;
  ASSERT_GT(level, 4) << "the first step was meant to be far too large";
  EXPECT_LE(errorOf(before, level - 1) / 3, tolerance);
  EXPECT_GT(errorOf(before, level - 2) / 3, tolerance);
  EXPECT_LE(difference(state, stepped(before, {level})), 1e-10);
  EXPECT_EQ(count.coupled_steps, 3 + 2 * (level - 2));
  EXPECT_EQ(control.lastPair().previous_error, std::ldexp(0.5, 3 * (2 - level)));
}

// The largest pair whose steps, solved from their begin, meet the tolerance; guesses that come from
// a refused step's second solution would lead on to smaller ones.
TEST_F(RunawayRichardsonTest, TakesTheLargestPairThatHasNotRunAway)
{
  const double tolerance = 1e-2;
  RichardsonControl control({stepper.step}, adaptive(tolerance, 1));
  SolveCount count;
  const double fell = dynamics::distance(*model.surface, stepped(state, {0}).alpha, state.alpha);
  ASSERT_GT(fell, 1) << "half a second was meant to be too long";
  auto const before = state.clone();
  const int level = control.advance(state, count).level;
  EXPECT_LE(errorOf(before, level - 1) / 3, tolerance);
  EXPECT_GT(errorOf(before, level - 2) / 3, tolerance);
  EXPECT_LE(difference(state, stepped(before, {level})), 1e-8);
  EXPECT_EQ(count.failures, 0);
}

TEST_F(RichardsonControlTest, MeasuresInTheNormAskedFor)
{
  auto settings = adaptive(1e-4, 8);
  settings.norm = Norm::maximum;
  auto control = this->control(settings);
  for (int n = 0; n < 3; ++n) {
    auto const before = state.clone();
    auto const accepted = control.advance(state, count);
    control.advance(state, count);
    EXPECT_LE(accepted.error, 1e-4);
    EXPECT_NEAR(accepted.error, errorOf(before, accepted.level - 1, Norm::maximum) / 3, 1e-10);
    EXPECT_GT(accepted.error, 1.1 * errorOf(before, accepted.level - 1) / 3);
  }
}

TEST_F(FirstOrderRichardsonTest, TakesTheWholeDifferenceForTheError)
{
  RichardsonControl control({stepper.step, 1}, adaptive(1e-3, 8));
  SolveCount count;
  for (int n = 0; n < 3; ++n) {
    auto const before = state.clone();
    auto const accepted = control.advance(state, count);
    control.advance(state, count);
    EXPECT_NEAR(accepted.error, errorOf(before, accepted.level - 1), 1e-10);
  }
}

TEST_F(RichardsonControlTest, SaysWhenTheSmallestStepIsTooCoarse)
{
  auto control = this->control(adaptive(1e-12, 4, 6));
  for (int n = 0; n < 4; ++n) {
    auto const accepted = control.advance(state, count);
    EXPECT_EQ(accepted.level, 6);
    EXPECT_FALSE(accepted.within_tolerance);
    EXPECT_GT(accepted.error, 1e-12);
  }
  EXPECT_EQ(count.coupled_steps, 3 + 2 * 2 + 3);
}

TEST_F(RichardsonControlTest, StaysBelowTheLargestStep)
{
  auto settings = adaptive(1e3, 0);
  settings.coarsest_level = 5; // of the step that a pair is compared with
  auto control = this->control(settings);
  for (int n = 1; n <= 6; ++n) {
    EXPECT_EQ(control.advance(state, count).level, 6);
    EXPECT_EQ(state.time, n * half_seconds.ticks(6));
  }
}

TEST_F(RichardsonControlTest, ContinuesFromItsMemoryExactly)
{
  // Once with a pair completed, once in the middle of one.
  for (int num_steps : {8, 9}) {
    auto from = state.clone();
    auto control = this->control(adaptive(1e-4, 8));
    for (int n = 0; n < num_steps; ++n) {
      control.advance(from, count);
    }
    EXPECT_EQ(control.memory().trial.has_value(), num_steps == 9);
    Stepper other(model, RateUpdate::newmark(0.25), half_seconds);
    RichardsonControl continued({other.step}, adaptive(1e-4, 8));
    expectSameContinuation(control, from, continued, 9);
    EXPECT_EQ(continued.memory().num_steps, num_steps + 9);
  }
}

TEST_F(RichardsonControlTest, MeetsInstants)
{
  auto settings = adaptive(1e3, 8);
  settings.coarsest_level = 7;
  auto control = this->control(settings, several_instants);
  expectInstantsMet(control);
}

TEST_F(RichardsonControlTest, DoesNotKnowOfInstantsFarAway)
{
  auto control = this->control(adaptive(1e-4, 8), far_instant);
  auto free = this->control(adaptive(1e-4, 8));
  expectSameStepsFarFromInstants(control, free);
}

TEST_F(RichardsonControlTest, ContinuesBeforeAnInstantExactly)
{
  auto settings = adaptive(1e3, 8);
  settings.coarsest_level = 7;
  auto control = this->control(settings, near_instant);
  auto continued = this->control(settings, near_instant);
  expectContinuationBeforeAnInstant(control, continued);
}

TEST_F(RichardsonControlTest, HalvesStepsThatCannotBeSolved)
{
  // Few iterations of the fixed point have to do: that takes steps finer than the tolerance does.
  Stepper hasty(model, RateUpdate::newmark(0.25), half_seconds, coupling(1e-3, 1));
  RichardsonControl control({hasty.step}, adaptive(1e-2, 2));
  auto free = this->control(adaptive(1e-2, 2));
  expectSmallerSteps(control, free);
}

TEST_F(RichardsonControlTest, GivesUpBelowTheSmallestStep)
{
  Stepper hasty(model, RateUpdate::newmark(0.25), half_seconds, coupling(1e-12, 1));
  RichardsonControl control({hasty.step}, adaptive(1e-2, 2, 5));
  asperity::test::expectRefusal<SolveError>([&] { control.advance(state, count); },
                                            {"t = 0 s", "0.015625 s", "fixed point"});
  EXPECT_EQ(state.time, 0);
}

// After a pair of the level 9: its error, that of the pair before it (0: unknown), the level next.
struct Prediction
{
  double error, previous_error;
  int level;
};

class RichardsonPrediction : public RichardsonControlTest,
                             public ::testing::WithParamInterface<Prediction>
{
};

// With tolerance 1e-4 and a ratio of 8: the step doubles if 8 times the error expected meets it
// with something to spare, and is halved if the error expected does not meet it.
TEST_P(RichardsonPrediction, ComesFromTheErrorAndItsTrend)
{
  auto const& given = GetParam();
  auto control = this->control(adaptive(1e-4, 9));
  Archive memory;
  control.save(memory, states);
  memory.set("level", 9);
  memory.set("error", given.error);
  memory.set("previous_error", given.previous_error);
  memory.set("trial/iterations", 4); // the second step of the pair
  states.save(memory, "trial/state", state);
  control.restore(memory, states);
  auto const accepted = control.advance(state, count);
  EXPECT_EQ(accepted.level, 9);
  EXPECT_EQ(accepted.error, given.error);
  EXPECT_EQ(accepted.iterations, 4);
  EXPECT_EQ(control.memory().level, given.level);
  // The error that the pair would have had at the next level.
  EXPECT_DOUBLE_EQ(control.lastPair().error, std::ldexp(given.error, 3 * (9 - given.level)));
  EXPECT_FALSE(control.memory().trial);
  EXPECT_EQ(count.coupled_steps, 0);
}

INSTANTIATE_TEST_SUITE_P(All, RichardsonPrediction,
                         ::testing::Values(Prediction{6e-6, 0, 8}, Prediction{1.3e-5, 0, 9},
                                           Prediction{9e-5, 0, 9}, // still meets it
                                           Prediction{6e-6, 6e-6, 8},
                                           Prediction{6e-6, 2.5e-6, 9}, // grows
                                           Prediction{1.2e-5, 3e-5, 8}, // falls, by half at best
                                           Prediction{2.6e-5, 1, 9},    // whatever came before
                                           Prediction{2.4e-5, 1e-9, 9}, // grows, by 4 at worst
                                           Prediction{2.6e-5, 1e-9, 10},
                                           Prediction{6e-5, 3e-5, 10}));

TEST_F(RichardsonControlTest, PredictionsStayBetweenTheLevelsAllowed)
{
  for (double error : {1e-9, 1.}) {
    auto settings = adaptive(1e-4, 9, 9);
    settings.coarsest_level = 8;
    auto control = this->control(settings);
    Archive memory;
    control.save(memory, states);
    memory.set("level", 9);
    memory.set("error", error);
    memory.set("trial/iterations", 1);
    states.save(memory, "trial/state", state);
    control.restore(memory, states);
    control.advance(state, count);
    EXPECT_EQ(control.memory().level, 9);
    EXPECT_EQ(control.lastPair().error, error);
  }
}

// First guesses half way and straight on spare fixed point iterations.
TEST_F(RichardsonControlTest, GuessesAreBetterThanTheStateBefore)
{
  Stepper loose(model, RateUpdate::newmark(0.25), half_seconds, coupling(1e-5, 100));
  RichardsonControl control({loose.step}, adaptive(1e-5, 10));
  SolveCount plain;
  for (int n = 0; n < 20; ++n) {
    auto const before = state.clone();
    const int level = control.advance(state, count).level;
    control.advance(state, count);
    auto whole = before.clone(), first = before.clone();
    loose.step.solve(before, level - 1, whole, plain);
    loose.step.solve(before, level, first, plain);
    auto second = first.clone();
    loose.step.solve(first, level, second, plain);
  }
  EXPECT_LT(10 * count.rate_problems, 8 * plain.rate_problems);
}

// Half way, and once more as far.
TEST_F(RichardsonControlTest, GuessesLieOnTheLineThroughTwoStates)
{
  auto const later = stepped(state, {6, 6});
  for (double weight : {0.5, 2.}) {
    auto const guess = blend({weight, later, state});
    auto const expected_v = (weight * denseOf(*later.v) + (1 - weight) * denseOf(*state.v)).eval();
    auto const expected_alpha =
      (weight * denseOf(later.alpha) + (1 - weight) * denseOf(state.alpha)).eval();
    EXPECT_LE((denseOf(*guess.v) - expected_v).norm(), 1e-15 * expected_v.norm());
    EXPECT_LE((denseOf(guess.alpha) - expected_alpha).norm(), 1e-15 * expected_alpha.norm());
  }
}
} // namespace asperity::dynamics
