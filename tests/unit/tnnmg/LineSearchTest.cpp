#include "tnnmg/LineSearch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace asperity::tnnmg
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Search
{
  double step = 0;
  int evaluations = 0; // of the slope, without that at zero
};

template <class Slope>
Search searchFrom(double start, Slope const& slope, double tolerance)
{
  Search result;
  const auto counted = [&](double t) {
    ++result.evaluations;
    return slope(t);
  };
  result.step = findSignChange(counted, start, tolerance);
  return result;
}

template <class Slope>
Search search(Slope const& slope, double tolerance = 0)
{
  return searchFrom(slope(0), slope, tolerance);
}
} // namespace

TEST(LineSearch, FindsTheRootOfALinearSlope)
{
  for (double root : {1e-9, 0.3, 1., 1.5, 700.}) {
    const auto result = search([root](double t) { return 5 * (t - root); });
    EXPECT_NEAR(result.step, root, 1e-13 * root);
    EXPECT_LE(result.evaluations, 20);
  }
}

TEST(LineSearch, TakesTheFullStepWithinTolerance)
{
  const auto result = search([](double t) { return t < 1 ? -1. : 0.009; }, 1e-2);
  EXPECT_EQ(result.step, 1);
  EXPECT_EQ(result.evaluations, 1);
}

TEST(LineSearch, StopsBeforeAJumpOfTheSlope)
{
  for (double at : {1e-6, 0.3, 0.9999, 3.7, 100.}) {
    const auto slope = [at](double t) { return t < at ? -1e-3 : 1e3; };
    const auto result = search(slope, 1e-2);
    EXPECT_LT(slope(result.step), 0) << "the step passes the kink at " << at;
    EXPECT_NEAR(result.step, at, 1e-5 * at);
    EXPECT_LE(result.evaluations, 100);
  }
}

TEST(LineSearch, EndsAtTheLargestStep)
{
  for (double largest : {1e-6, 0.3, 1.}) {
    const auto falling = [](double) { return -1.; };
    EXPECT_EQ(findSignChange(falling, -1, 1e-2, largest), largest);
    const auto turning = [largest](double t) { return t - largest / 2; };
    EXPECT_NEAR(findSignChange(turning, turning(0), 0, largest), largest / 2, 1e-13 * largest);
  }
}

TEST(LineSearch, ExpandsAlongAFlatSlope)
{
  const auto result = search([](double t) { return t < 200 ? -1. : t - 200.; }, 1e-2);
  EXPECT_NEAR(result.step, 200, 0.02);
  EXPECT_LE(result.evaluations, 40);
}

TEST(LineSearch, EndsWhereTheFunctionFallsForEver)
{
  const auto result = search([](double) { return -1.; });
  EXPECT_GE(result.step, 1000);
  EXPECT_TRUE(std::isfinite(result.step));
}

TEST(LineSearch, DoesNotMoveAlongADirectionThatDoesNotDescend)
{
  for (double start : {0., 1e-300, 3., infinity, std::nan("")}) {
    const auto result = searchFrom(
      start, [](double t) { return t - 0.5; }, 1e-2);
    EXPECT_EQ(result.step, 0);
    EXPECT_EQ(result.evaluations, 0);
  }
}

TEST(LineSearch, SurvivesSlopesThatAreNoNumbers)
{
  EXPECT_EQ(findSignChange([](double) { return std::nan(""); }, -1., 1e-2), 0);
  const auto wall = [](double t) { return t < 0.25 ? -1. : infinity; };
  EXPECT_NEAR(search(wall).step, 0.25, 1e-12);
}

TEST(LineSearch, WorksAtAllMagnitudes)
{
  for (double unit : {1e-290, 1e-30, 1e30, 1e290}) {
    const auto result = search([unit](double t) { return unit * (t - 0.3); });
    EXPECT_NEAR(result.step, 0.3, 1e-13);
  }
  // A slope that rises like friction's near rest, by 12 decades within the step.
  const auto result = search([](double t) { return std::log10(t + 1e-12) + 5; }, 1e-10);
  EXPECT_NEAR(result.step, 1e-5, 1e-10);
}

// A random convex function of kinks and parabolas: the step never passes its minimum, so that it
// descends, and comes close to it.
TEST(LineSearch, DescendsForRandomConvexFunctions)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<std::pair<double, double>> kinks(4);
    double sum = 0;
    for (auto& [at, jump] : kinks) {
      at = std::pow(10, 4 * uniform(generator) - 3);
      jump = std::pow(10, 6 * uniform(generator) - 3);
      sum += jump;
    }
    const double start = -sum * uniform(generator);
    const double curvature = uniform(generator) < 0.3 ? 0 : std::pow(10, 4 * uniform(generator));
    const auto slope = [&](double t) {
      double value = start + curvature * t;
      for (auto const& [at, jump] : kinks) {
        value += t >= at ? jump : 0;
      }
      return value;
    };
    double low = 0;
    double high = 20;
    while (low < (low + high) / 2 && (low + high) / 2 < high) {
      (slope((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
    }
    const auto result = search(slope);
    EXPECT_LE(result.step, high) << "trial " << trial;
    EXPECT_GE(result.step, low * (1 - 1e-5)) << "trial " << trial;
    EXPECT_LE(result.evaluations, 100);
  }
}
} // namespace asperity::tnnmg
