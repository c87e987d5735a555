#include "friction/laws/SlipWeakening.hpp"

#include "unit/friction/Fault.hpp"

#include <gtest/gtest.h>

namespace asperity::friction::test
{
namespace
{
constexpr double mu_s = 0.677, mu_d = 0.525, distance = 0.4; // of SCEC's TPV5
constexpr double weight = 50, sigma_n = 120e6, cohesion = 2e6, curvature = 3e9;

double strength(double alpha) // N
{
  return weight * ((mu_s - (mu_s - mu_d) * alpha) * sigma_n + cohesion);
}

// Nodes with the states alpha.
struct SlipWeakeningFault
{
  explicit SlipWeakeningFault(Values const& alphas)
      : kernels(makeFrictionKernels(
          "Slip Weakening",
          {toDevice(Values(alphas.size(), weight)), toDevice(Values(alphas.size(), cohesion)),
           toDevice(Values(alphas.size(), 1.)),
           parametersOf(std::vector<Values>(alphas.size(), {mu_s, mu_d}))}))
      , at{toDevice(alphas), toDevice(Values(alphas.size(), sigma_n))}
  {
  }
  std::unique_ptr<FrictionKernels> kernels;
  StateAndStress at;
};

const Values states{0, 0.3, 1};

std::vector<Values> rows(int T, Values const& lengths)
{
  std::vector<Values> result;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    result.push_back(scaled(direction(T, static_cast<int>(i)), lengths[i]));
  }
  return result;
}

// curvature s + strength = load, or rest.
TEST(SlipWeakening, NodesRestUntilTheForceExceedsTheirStrength)
{
  for (const int T : {1, 2}) {
    for (const double excess : {-1e9, -1., 0., 1e-3, 1., 5e9}) {
      Values loads;
      for (const double alpha : states) {
        loads.push_back(strength(alpha) + excess);
      }
      const SlipWeakeningFault fault(states);
      const auto v = toDevice(rows(T, {0, 1e-9, 3}));
      const auto r = rows(T, loads);
      ASSERT_EQ(fault.kernels->minimise(allNodes(3), toDevice(Values(3, curvature)), toDevice(r),
                                        fault.at, v),
                0);
      const auto host = toHost(v);
      for (int i = 0; i < 3; ++i) {
        const double s = std::max(excess, 0.) / curvature;
        for (int j = 0; j < T; ++j) {
          const double rounding = 4 * epsilon * loads[i] / curvature;
          EXPECT_NEAR(host(i, j), s * r[i][j] / loads[i], rounding) << excess << ' ' << i;
          EXPECT_TRUE(excess >= 0 || host(i, j) == 0);
        }
      }
    }
  }
}

TEST(SlipWeakening, HasAKinkAtRestAndAConstantForceElsewhere)
{
  for (const int T : {1, 2}) {
    const SlipWeakeningFault fault(states);
    const BlockView gradient("gradient", 3, T);
    const HessianView hessian("hessian", 3, T, T);
    const FlagView kinked("kinked", 3);
    const auto v = rows(T, {0, 1e-9, 3});
    fault.kernels->linearise(toDevice(v), fault.at, gradient, hessian, kinked);
    const auto g = toHost(gradient);
    const auto h = toHost(hessian);
    const auto flags = toHost(kinked);
    for (int i = 0; i < 3; ++i) {
      const double s = static_cast<double>(norm(widened(v[i])));
      EXPECT_EQ(flags(i), s == 0);
      const double force = s == 0 ? 0 : strength(states[i]);
      for (int j = 0; j < T; ++j) {
        EXPECT_NEAR(g(i, j), s == 0 ? 0 : force * v[i][j] / s, 1e-15 * force);
        for (int k = 0; k < T; ++k) {
          const double across = s == 0 || T == 1 ? 0 : (j == k) - v[i][j] * v[i][k] / (s * s);
          EXPECT_NEAR(h(i, j, k), s == 0 ? 0 : force / s * across, s == 0 ? 0 : 1e-15 * force / s);
        }
      }
    }
  }
}

TEST(SlipWeakening, FunctionalIsTheStrengthTimesTheLength)
{
  const SlipWeakeningFault fault(states);
  const auto v = toDevice(rows(2, {0, 2, 3})), d = toDevice(rows(2, {5, -1, 4}));
  const double expected = strength(0) * 5 - strength(0.3) * 1 + strength(1) * 4;
  EXPECT_NEAR(fault.kernels->difference(v, d, fault.at).change, expected, 1e-14 * expected);
  EXPECT_NEAR(fault.kernels->slope(v, d, 0, fault.at), expected, 1e-14 * expected);
}

TEST(SlipWeakening, StateIsTheShareOfTheDistanceAndStaysAtOne)
{
  const SlipWeakeningState law{distance};
  EXPECT_EQ(law.flow(0, 1e9, 0.25), 0.25);
  EXPECT_DOUBLE_EQ(law.flow(0.1, 1, 0.25), 0.5);
  EXPECT_EQ(law.flow(0.1, 4, 0.25), 1);
  EXPECT_EQ(law.flow(0.1, 4, 1.5), 1.5);
  EXPECT_EQ(law.rate(0.1, 0.5), 0.25);
  EXPECT_EQ(law.rate(0.1, 1), 0);
}

TEST(SlipWeakening, KnowsTheStateOfACoefficientBetweenBoth)
{
  const SlipWeakeningLaw law{mu_s, mu_d};
  EXPECT_DOUBLE_EQ(law.stateFor(1, law.at(0.7).mu(1)), 0.7);
  EXPECT_FALSE(std::isfinite(law.stateFor(1, 0.7)));
  EXPECT_FALSE(std::isfinite(law.stateFor(1, 0.5)));
}
} // namespace
} // namespace asperity::friction::test
