#include "unit/friction/Fault.hpp"

#include <gtest/gtest.h>

#include <random>

namespace asperity::friction::test
{
namespace
{
// One node's minimisation: curvature s + weight (sigma_n mu + C) = load.
struct Problem
{
  ReferenceNode node;
  double curvature;
  double load;
  double guess;
};

// Runs the kernel over all problems, r along direction(T, i); returns the minimisers.
std::vector<Values> minimise(std::vector<Problem> const& problems, int T, int& num_failed)
{
  std::vector<ReferenceNode> nodes;
  Values curvature;
  std::vector<Values> r, guess;
  const int num_nodes = static_cast<int>(problems.size());
  for (int i = 0; i < num_nodes; ++i) {
    nodes.push_back(problems[i].node);
    curvature.push_back(problems[i].curvature);
    r.push_back(scaled(direction(T, i), problems[i].load));
    guess.push_back(scaled(direction(T, i + 1), problems[i].guess));
  }
  const Fault fault(nodes);
  const auto v = toDevice(guess);
  num_failed =
    fault.kernels->minimise(allNodes(num_nodes), toDevice(curvature), toDevice(r), fault.at, v);
  const auto host = toHost(v);
  std::vector<Values> result;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    result.push_back(T == 1 ? Values{host(i, 0)} : Values{host(i, 0), host(i, 1)});
  }
  return result;
}

// Bisection for log s in long double; 0 below the smallest slip rate.
Real bisected(Problem const& problem)
{
  const Real excess = problem.load - Real(problem.node.weight) * problem.node.cohesion;
  Real low = std::log(1e-300L / problem.node.factor);
  Real high = excess > 0 ? std::log(excess / problem.curvature) : low;
  const auto residual = [&](Real log_s) {
    const Real s = std::exp(log_s);
    return problem.curvature * s + problem.node.force(s) - problem.load;
  };
  if (high <= low || residual(low) >= 0) {
    return 0;
  }
  for (int k = 0; k < 120; ++k) {
    const Real middle = (low + high) / 2;
    (residual(middle) > 0 ? high : low) = middle;
  }
  return std::exp(high);
}

void expectMinimiser(Problem const& problem, Values const& v, Values const& unit)
{
  auto const& node = problem.node;
  const Real s = norm(widened(v));
  const Real expected = bisected(problem);
  const Real inertia = problem.curvature * s;
  const Real tolerance =
    4 * epsilon * (inertia + node.force(s) + problem.load) + 2 * node.forceTolerance(s);
  if (s == 0) { // the neighbourhood of 1e-300 m/s may go either way
    EXPECT_LE(expected, 2e-300L);
    return;
  }
  EXPECT_GT(problem.load, node.weight * node.cohesion);
  EXPECT_LE(std::abs(inertia + node.force(s) - problem.load), tolerance);
  // The equation's rounding over its slope, by log s.
  const Real step = 1e-6L;
  const Real slope = inertia + (node.force(s * std::exp(step)) - node.force(s)) / step;
  EXPECT_LE(std::abs(s - expected) / expected, tolerance / slope + 8 * epsilon);
  for (std::size_t j = 0; j < unit.size(); ++j) {
    EXPECT_NEAR(v[j], static_cast<double>(s) * unit[j], 1e-14 * static_cast<double>(s));
  }
}

class Draw
{
public:
  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  double magnitude(double low, double high) { return std::pow(10, uniform(low, high)); }
  bool coin() { return generator_() % 2 == 0; }

  ReferenceNode node(std::string const& law)
  {
    const ReferenceLaw parameters{law, magnitude(-3, -1), coin() ? 0.0 : magnitude(-3, -1.5),
                                  magnitude(-12, -2), uniform(0, 0.8)};
    // b alpha / a from -2000 to 2000
    return {parameters,
            magnitude(-4, 5),
            coin() ? magnitude(0, 9) : 0.0,
            coin() ? magnitude(0, 7) : 0.0,
            coin() ? 1.0 : 2.0,
            uniform(-100, 100)};
  }

  // Any load and any guess, or a load that makes a drawn slip rate the solution, seen from close
  // by.
  Problem problem(std::string const& law)
  {
    Problem problem{node(law), magnitude(-3, 12), magnitude(-6, 12),
                    coin() ? 0 : magnitude(-18, 2)};
    if (coin()) {
      const double s = magnitude(-20, 2);
      const auto force = static_cast<double>(problem.node.force(s));
      problem.curvature = (1e-3 + force) / s * magnitude(-6, 6);
      problem.load = problem.curvature * s + force;
      problem.guess = coin() ? s : s * uniform(0.5, 2);
    }
    return problem;
  }

private:
  std::mt19937 generator_{7};
};

TEST(Minimise, SolvesItsEquationOverAWideRangeOfParameters)
{
  Draw draw;
  for (auto const& law : both_laws) {
    for (const int T : {1, 2}) {
      std::vector<Problem> problems;
      problems.reserve(4000);
      for (int i = 0; i < 4000; ++i) {
        problems.push_back(draw.problem(law));
      }
      int num_failed = -1;
      const auto v = minimise(problems, T, num_failed);
      EXPECT_EQ(num_failed, 0);
      for (int i = 0; i < static_cast<int>(problems.size()); ++i) {
        expectMinimiser(problems[i], v[i], direction(T, i));
        if (::testing::Test::HasFailure()) {
          auto const& p = problems[i];
          FAIL() << law << " T=" << T << " i=" << i << " a=" << p.node.law.a
                 << " b=" << p.node.law.b << " alpha=" << p.node.alpha
                 << " curvature=" << p.curvature << " load=" << p.load;
        }
      }
    }
  }
}

TEST(Minimise, SlipsIfAndOnlyIfTheLoadExceedsCohesion)
{
  for (auto const& law : both_laws) {
    std::vector<Problem> problems;
    for (const double ratio : {0.0, 0.5, 1 - epsilon, 1.0, 1 + 2 * epsilon, 1 + 1e-9, 2.0}) {
      // Without normal stress, and at a state at which V_alpha is an ordinary slip rate.
      problems.push_back({{{law, 0.01, 0.015, 1e-6, 0.6}, 3, 0, 1e3, 1, 0}, 1e3, 3e3 * ratio, 1});
      problems.push_back({{{law, 0.01, 0.015, 1e-6, 0}, 3, 1e6, 1e3, 1, 0}, 1e3, 3e3 * ratio, 1});
    }
    int num_failed = -1;
    const auto v = minimise(problems, 2, num_failed);
    EXPECT_EQ(num_failed, 0);
    for (std::size_t i = 0; i < problems.size(); ++i) {
      EXPECT_EQ(norm(widened(v[i])) > 0, problems[i].load > 3e3) << law << ' ' << problems[i].load;
    }
  }
}

TEST(Minimise, RateBelowTheSmallestIsRest)
{
  // V_alpha is about exp(-2000): a load of half of what sliding at 1e-300 m/s needs.
  for (auto const& law : both_laws) {
    const ReferenceNode node{{law, 0.001, 0.02, 1e-9, 0.3}, 1, 1e6, 0, 1, 90};
    const auto strength = static_cast<double>(node.force(1e-300L));
    int num_failed = -1;
    const auto v =
      minimise({{node, 1e6, 0.5 * strength, 1e-3}, {node, 1e6, 2 * strength, 0}}, 1, num_failed);
    EXPECT_EQ(num_failed, 0);
    EXPECT_EQ(v[0][0], 0);
    EXPECT_LT(v[1][0], 0); // against direction(1, 1)
  }
}

TEST(Minimise, CountsFailuresAndLeavesTheirNodesAlone)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (auto const& law : both_laws) {
    const ReferenceNode good{{law, 0.01, 0.015, 1e-6, 0.6}, 3, 1e6, 0, 1, 0};
    ReferenceNode lost = good;
    lost.alpha = nan;
    int num_failed = -1;
    const auto v = minimise({{good, 0, 1e7, 0.25},
                             {good, 1e3, nan, 0.25},
                             {lost, 1e3, 1e7, 0.25},
                             {good, 1e3, 1e7, 0.25}},
                            1, num_failed);
    EXPECT_EQ(num_failed, 3);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(std::abs(v[i][0]), 0.25);
    }
    EXPECT_NE(std::abs(v[3][0]), 0.25);
  }
}

TEST(Minimise, TouchesOnlyTheNodesItIsGiven)
{
  const Fault fault(variousNodes("Regularised"));
  const int num_nodes = static_cast<int>(fault.alpha.extent(0));
  const auto v = toDevice(std::vector<Values>(num_nodes, Values{-1, -1}));
  const auto r = toDevice(std::vector<Values>(num_nodes, Values{1e9, 2e9}));
  const auto curvature = toDevice(Values(num_nodes, 1e3));
  const auto nodes = allNodes(5);
  EXPECT_EQ(fault.kernels->minimise(Kokkos::subview(nodes, Kokkos::make_pair(3, 5)), curvature, r,
                                    fault.at, v),
            0);
  const auto host = toHost(v);
  for (int i = 0; i < num_nodes; ++i) {
    EXPECT_EQ(host(i, 1) > 0, i == 3 || i == 4);
  }
  const BlockView wide("wide", num_nodes, 3);
  EXPECT_THROW(fault.kernels->minimise(nodes, curvature, r, fault.at, wide), std::invalid_argument);
}
} // namespace
} // namespace asperity::friction::test
