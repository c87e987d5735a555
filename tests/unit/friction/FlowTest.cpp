#include "friction/Registry.hpp"
#include "unit/friction/Reference.hpp"
#include "unit/friction/StateConstants.hpp"
#include "unit/friction/Views.hpp"

#include <gtest/gtest.h>

namespace asperity::friction::test
{
namespace
{
const std::vector<double> slip_rates{0, 1e-300, 1e-20, 1e-9, 1e-6, 5e-5, 1, 1e2};
const std::vector<double> step_sizes{0, 1e-6, 1e-3, 0.3, 1, 1e3, 1e9};
const std::vector<double> states{-100, -31.4, -2, -1e-9, 0, 1, 12, 55, 100};
const std::vector<std::string> both_laws{"Ageing", "Slip"};

// alpha after dt at every node; all vectors (num_nodes).
Values flow(std::string const& law, Values const& V, double dt, Values const& alpha)
{
  const std::vector<Values> parameters(V.size(), {L, reference_rate, 0.});
  const auto kernels = makeStateKernels(law, parametersOf(parameters));
  const NodeView result("result", V.size());
  EXPECT_EQ(kernels->flow(toDevice(V), dt, toDevice(alpha), result), 0);
  return toVector(result);
}

Real referenceFlow(std::string const& law, Real V, Real dt, Real alpha)
{
  if (V == 0) {
    return law == "Ageing" ? std::log(std::exp(alpha) + reference_rate * dt / L) : alpha;
  }
  const Real q = V * dt / L;
  if (law == "Ageing") {
    return std::log(std::exp(alpha - q) - reference_rate / V * std::expm1(-q));
  }
  const Real steady = std::log(reference_rate / V);
  return steady + (alpha - steady) * std::exp(-q);
}

// Every slip rate with every state.
void pairs(Values& V, Values& alpha)
{
  for (const double rate : slip_rates) {
    for (const double state : states) {
      V.push_back(rate);
      alpha.push_back(state);
    }
  }
}

TEST(Flow, IsExactForEverySlipRateAndStepSize)
{
  Values V, alpha;
  pairs(V, alpha);
  for (auto const& law : both_laws) {
    for (const double dt : step_sizes) {
      const auto result = flow(law, V, dt, alpha);
      for (std::size_t i = 0; i < V.size(); ++i) {
        const Real exact = referenceFlow(law, V[i], dt, alpha[i]);
        const Real digits =
          1 + std::abs(alpha[i]) + std::abs(exact) + std::abs(std::log(reference_rate));
        EXPECT_NEAR(result[i], static_cast<double>(exact),
                    static_cast<double>(4 * epsilon * digits))
          << law << ' ' << V[i] << ' ' << dt << ' ' << alpha[i];
      }
    }
  }
}

TEST(Flow, TwoStepsAreOneOfTheirSum)
{
  Values V, alpha;
  pairs(V, alpha);
  for (auto const& law : both_laws) {
    for (const double first : step_sizes) {
      for (const double second : step_sizes) {
        const auto composed = flow(law, V, second, flow(law, V, first, alpha));
        const auto direct = flow(law, V, first + second, alpha);
        for (std::size_t i = 0; i < V.size(); ++i) {
          EXPECT_NEAR(composed[i], direct[i],
                      8 * epsilon * (20 + std::abs(alpha[i]) + std::abs(direct[i])))
            << law << ' ' << V[i] << ' ' << first << ' ' << second << ' ' << alpha[i];
        }
      }
    }
  }
}

TEST(Flow, SteadyStateIsFixedAndEverythingRunsThere)
{
  const Values V{1e-300, 1e-20, 1e-9, 5e-5, 1, 1e2};
  const std::vector<Values> parameters(V.size(), {L, reference_rate, 0.});
  for (auto const& law : both_laws) {
    const NodeView view("steady", V.size());
    makeStateKernels(law, parametersOf(parameters))->steadyState(toDevice(V), view);
    const Values steady = toVector(view);
    for (std::size_t i = 0; i < V.size(); ++i) {
      EXPECT_NEAR(steady[i], std::log(reference_rate) - std::log(V[i]), 1e-13);
    }
    for (const double dt : step_sizes) {
      const auto after = flow(law, V, dt, steady);
      for (std::size_t i = 0; i < V.size(); ++i) {
        EXPECT_NEAR(after[i], steady[i], 4 * epsilon * (20 + std::abs(steady[i])));
      }
    }
    const auto later = flow(law, {5e-5, 1, 1e2}, 1e9, {-100, 80, 3});
    EXPECT_NEAR(later[0], 0, 1e-14);
    EXPECT_NEAR(later[1], std::log(5e-5), 1e-14);
    EXPECT_NEAR(later[2], std::log(5e-7), 1e-14);
  }
}

TEST(Flow, AtRestTheAgeingLawHealsAndTheSlipLawWaits)
{
  const double theta0 = L / reference_rate * std::exp(-3.0);
  for (const double dt : {1e-6, 1.0, 3e9}) {
    const double theta = L / reference_rate * std::exp(flow("Ageing", {0}, dt, {-3})[0]);
    EXPECT_NEAR(theta, theta0 + dt, 1e-14 * (theta0 + dt));
    EXPECT_EQ(flow("Slip", {0}, dt, {-3})[0], -3);
  }
}

TEST(Flow, MayOverwriteItsArgument)
{
  const auto kernels = makeStateKernels("Ageing", parametersOf({{L, reference_rate, 0.}}));
  const auto alpha = toDevice(Values{2.0});
  kernels->flow(toDevice(Values{1e-6}), 1, alpha, alpha);
  EXPECT_EQ(toHost(alpha)(0), flow("Ageing", {1e-6}, 1, {2})[0]);
}

TEST(SteadyState, IsInfinitelyOldAtRest)
{
  for (auto const& law : both_laws) {
    const NodeView alpha("alpha", 1);
    makeStateKernels(law, parametersOf({{L, reference_rate, 0.}}))
      ->steadyState(toDevice(Values{0}), alpha);
    EXPECT_EQ(toHost(alpha)(0), std::numeric_limits<double>::infinity());
  }
}
} // namespace
} // namespace asperity::friction::test
