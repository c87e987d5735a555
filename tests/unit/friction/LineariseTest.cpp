#include "unit/friction/Fault.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace asperity::friction::test
{
namespace
{
Vector2 referenceGradient(ReferenceNode const& node, Vector2 const& w)
{
  const Real s = norm(w);
  return {node.force(s) * w[0] / s, node.force(s) * w[1] / s};
}

Real distanceFromKink(ReferenceNode const& node, Real s)
{
  return std::abs(std::log(node.factor * s / node.law.vAlpha(node.alpha)));
}

template <class View>
using OnHost = decltype(toHost(std::declval<View>()));

struct Linearisation
{
  Linearisation(std::vector<ReferenceNode> const& nodes, std::vector<Values> const& rates)
  {
    const Fault fault(nodes);
    const auto n = nodes.size(), T = rates.at(0).size();
    const BlockView gradient_view("gradient", n, T);
    const HessianView hessian_view("hessian", n, T, T);
    const FlagView kinked_view("kinked", n);
    fault.kernels->linearise(toDevice(rates), fault.at, gradient_view, hessian_view, kinked_view);
    gradient = toHost(gradient_view);
    hessian = toHost(hessian_view);
    kinked = toHost(kinked_view);
  }

  OnHost<BlockView> gradient;
  OnHost<HessianView> hessian;
  OnHost<FlagView> kinked;
};

TEST(Linearise, GradientAndHessianAreThoseOfTheFunctional)
{
  for (auto const& law : both_laws) {
    const auto nodes = variousNodes(law);
    constexpr Real largest = std::numeric_limits<double>::max();
    for (const int T : {1, 2}) {
      for (const double length : {1e-300, 1e-20, 1e-6, 1.0, 1e2}) {
        std::vector<Values> rates;
        rates.reserve(nodes.size());
        for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
          rates.push_back(scaled(direction(T, i), length));
        }
        const Linearisation result(nodes, rates);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          const Vector2 w = widened(rates[i]);
          const Vector2 exact = referenceGradient(nodes[i], w);
          const auto tolerance = static_cast<double>(2 * nodes[i].forceTolerance(norm(w)));
          const Real step = 1e-5L * length;
          for (int j = 0; j < T; ++j) {
            EXPECT_NEAR(result.gradient(i, j), static_cast<double>(exact[j]), tolerance);
            Vector2 above = w, below = w;
            above[j] += step;
            below[j] -= step;
            const Vector2 high = referenceGradient(nodes[i], above);
            const Vector2 low = referenceGradient(nodes[i], below);
            for (int k = 0; k < T && !result.kinked(i); ++k) {
              const Real quotient = (high[k] - low[k]) / (2 * step);
              const Real scale = nodes[i].force(norm(w)) / norm(w) + std::abs(quotient);
              // A double's smallest coefficient of friction, by s.
              const Real underflow = nodes[i].weight * nodes[i].sigma_n * smallest / norm(w);
              EXPECT_LE(std::abs(result.hessian(i, j, k) - quotient), 1e-8 * scale + 2 * underflow)
                << law << " T=" << T << ' ' << length << " alpha=" << nodes[i].alpha;
              EXPECT_EQ(result.hessian(i, j, k), result.hessian(i, k, j));
            }
          }
          const bool near_kink = law == "Truncated" && distanceFromKink(nodes[i], length) < 1e-9;
          const Real radial = nodes[i].weight * nodes[i].sigma_n * nodes[i].factor *
                              nodes[i].law.derivative(nodes[i].factor * length, nodes[i].alpha);
          const Real transverse = T == 1 ? Real(0) : nodes[i].force(length) / length;
          EXPECT_EQ(result.kinked(i), near_kink || std::max(radial, transverse) > largest)
            << law << " T=" << T << ' ' << length << " alpha=" << nodes[i].alpha;
        }
      }
    }
  }
}

TEST(Linearise, AtRestCohesionIsAKink)
{
  for (auto const& law : both_laws) {
    for (const int T : {1, 2}) {
      const ReferenceNode smooth{{law, 0.01, 0.015, 1e-6, 0.6}, 3, 1e6, 0, 2, 1};
      ReferenceNode cohesive = smooth, stiff = smooth, unloaded = cohesive;
      cohesive.cohesion = 10;
      stiff.alpha = 600; // 1 / V_alpha is beyond the largest double
      unloaded.sigma_n = 0;
      const Linearisation result({smooth, cohesive, stiff, unloaded},
                                 std::vector<Values>(4, Values(T, 0.0)));
      const bool regularised = law == "Regularised";
      const Real slope = smooth.law.a / (2 * smooth.law.vAlpha(1));
      const auto expected = static_cast<double>(regularised ? 3e6L * 2 * slope : Real(0));
      EXPECT_EQ(result.kinked(0), 0);
      EXPECT_EQ(result.kinked(1), 1);
      EXPECT_EQ(result.kinked(2), regularised ? 1 : 0);
      EXPECT_EQ(result.kinked(3), 0);
      for (int j = 0; j < T; ++j) {
        for (int k = 0; k < T; ++k) {
          EXPECT_NEAR(result.hessian(0, j, k), j == k ? expected : 0, 1e-12 * expected);
          EXPECT_EQ(result.hessian(1, j, k), 0);
          EXPECT_EQ(result.hessian(2, j, k), 0);
          EXPECT_EQ(result.hessian(3, j, k), 0);
        }
        for (int i = 0; i < 4; ++i) {
          EXPECT_EQ(result.gradient(i, j), 0);
        }
      }
    }
  }
}

TEST(Linearise, TheTruncatedLawHasItsKinkAtVAlpha)
{
  const ReferenceNode node{{"Truncated", 0.01, 0.015, 1e-6, 0.6}, 3, 1e6, 5, 2, -20};
  const auto kink = static_cast<double>(node.law.vAlpha(-20)) / 2;
  const Linearisation result({node, node, node},
                             {{0.6 * kink, -0.8 * kink}, {kink * (1 - 1e-9), 0}, {0, kink * 1.1}});
  EXPECT_EQ(result.kinked(0), 1);
  EXPECT_EQ(result.kinked(1), 0);
  EXPECT_EQ(result.kinked(2), 0);
  EXPECT_EQ(result.hessian(0, 0, 0), 0);
  EXPECT_NEAR(result.gradient(0, 0), 15 * 0.6, 1e-8);
  EXPECT_NEAR(result.gradient(0, 1), 15 * -0.8, 1e-8);
  EXPECT_EQ(result.hessian(1, 0, 0), 0);
  EXPECT_NEAR(result.hessian(1, 1, 1), 15 / kink, 1e-6 / kink);
  EXPECT_NEAR(result.hessian(2, 1, 1), 3e6 * 0.01 / (1.1 * kink), 1e-3 / kink);
}

TEST(Coefficient, IsTheLawAtTheSlipRate)
{
  for (auto const& law : both_laws) {
    const auto nodes = variousNodes(law);
    const Fault fault(nodes);
    for (const int T : {1, 2}) {
      for (const double length : lengths) {
        std::vector<Values> rates;
        rates.reserve(nodes.size());
        for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
          rates.push_back(scaled(direction(T, i), length));
        }
        const NodeView mu("mu", nodes.size());
        fault.kernels->coefficient(toDevice(rates), fault.alpha, mu);
        const auto host = toHost(mu);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          const Real V = nodes[i].factor * norm(widened(rates[i]));
          EXPECT_NEAR(host(i), static_cast<double>(nodes[i].law.mu(V, nodes[i].alpha)),
                      static_cast<double>(2 * nodes[i].law.muTolerance(V, nodes[i].alpha)));
        }
      }
    }
  }
}
} // namespace
} // namespace asperity::friction::test
