#include "dynamics/watches/RingWatch.hpp"

#include "unit/io/Support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace asperity::dynamics
{
namespace
{
// The steps at which `rate` of the step's number is told.
std::vector<int> told(int num_steps, std::function<double(int)> const& rate)
{
  RingWatch watch;
  std::vector<int> steps;
  for (int step = 0; step < num_steps; ++step) {
    if (watch.note(step, rate(step))) {
      steps.push_back(step);
    }
  }
  return steps;
}
} // namespace

TEST(RingWatch, TellsTheTenthAndTheHundredthTurnInARow)
{
  const auto ringing = [](int step) { return step % 2 == 0 ? 1e-5 : 2e-5; };
  EXPECT_EQ(told(2000, ringing), (std::vector<int>{10, 100, 1000}));
}

TEST(RingWatch, IsSilentWhereStepsResolveTheRate)
{
  const auto wave = [](int step) { return std::pow(10, std::sin(step * M_PI / 4)); };
  EXPECT_TRUE(told(1000, wave).empty()) << "eight steps in a period";
  EXPECT_TRUE(told(1000, [](int step) { return step % 2 == 0 ? 1.0 : 1.4; }).empty()) << "small";
  EXPECT_TRUE(told(1000, [](int step) { return std::exp(step); }).empty()) << "grows";
  EXPECT_TRUE(told(1000, [](int) { return 0.0; }).empty()) << "rests";
}

TEST(RingWatch, CountsTurnsInARow)
{
  const auto pauses = [](int step) { return step % 9 % 2 == 0 ? 1.0 : 2.0; }; // after eight turns
  EXPECT_TRUE(told(1000, pauses).empty());
}

TEST(RingWatch, NamesTheCure)
{
  RingWatch watch;
  std::optional<Warning> warning;
  for (int step = 0; !warning && step < 20; ++step) {
    warning = watch.note(0.5 * step, step % 2 == 0 ? 1e-5 : 0.0);
  }
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->topic, "ringing");
  asperity::test::expectParts(warning->text, {"10 steps in a row", "t = 5 s", "Generalised Alpha"});
}
} // namespace asperity::dynamics
