#include "unit/friction/Fault.hpp"

#include <gtest/gtest.h>

namespace asperity::friction::test
{
namespace
{
// psi(v + d) - psi(v), and in `growth` |v + d| - |v|.
Real referenceDifference(ReferenceNode const& node, Vector2 const& v, Vector2 const& d,
                         Real& growth)
{
  const Real s = norm(v);
  const Real sum = s + norm({v[0] + d[0], v[1] + d[1]});
  growth = sum == 0 ? Real(0) : (d[0] * (2 * v[0] + d[0]) + d[1] * (2 * v[1] + d[1])) / sum;
  if (growth == 0) {
    return 0;
  }
  const Real mean = node.law.mean(node.factor * s, node.factor * growth, node.alpha);
  return node.weight * (node.sigma_n * mean + node.cohesion) * growth;
}

FrictionKernels::Difference difference(ReferenceNode const& node, Values const& v, Values const& d)
{
  const Fault fault({node});
  return fault.kernels->difference(toDevice(std::vector<Values>{v}),
                                   toDevice(std::vector<Values>{d}), fault.at);
}

TEST(Difference, IsThatOfTheFunctionalHoweverSmallTheStep)
{
  for (auto const& law : both_laws) {
    for (auto const& node : variousNodes(law)) {
      for (const int T : {1, 2}) {
        for (const double length : lengths) {
          for (const double ratio : {-2.0, -1.0, -0.4, -1e-6, -1e-12, 1e-15, 1e-9, 0.5, 1e4}) {
            const Values v = scaled(direction(T, 0), length);
            const Values d = scaled(direction(T, 2), length == 0 ? ratio : length * ratio);
            Real growth = 0;
            const Real exact = referenceDifference(node, widened(v), widened(d), growth);
            const auto result = difference(node, v, d);
            const Real fastest = std::max<Real>(length, std::abs(length + std::abs(growth)));
            // The last term: |v + d| - |v| may be one of the smallest doubles.
            const Real tolerance = 16 * epsilon * result.magnitude +
                                   2 * node.forceTolerance(fastest) * std::abs(growth) +
                                   4 * smallest * (1 + node.force(fastest));
            EXPECT_LE(std::abs(result.change - exact), tolerance)
              << law << " T=" << T << ' ' << length << ' ' << ratio << " alpha=" << node.alpha
              << " change=" << result.change;
            EXPECT_GE(result.magnitude * (1 + 8 * epsilon), std::abs(result.change));
          }
        }
      }
    }
  }
}

// On the line nothing cancels: the change is good to its own rounding.
TEST(Difference, KeepsTheDigitsOfASmallChange)
{
  for (auto const& law : both_laws) {
    const ReferenceNode node{{law, 0.01, 0.015, 1e-6, 0.6}, 2e2, 5e7, 1e5, 2, 3};
    for (const double d : {1e-18, 3e-16, -1e-15, 1e-9, -2e-5}) {
      Real growth = 0;
      const Real exact = referenceDifference(node, {1e-4L, 0}, {d, 0}, growth);
      const auto result = difference(node, {1e-4}, {d});
      EXPECT_NEAR(result.change, static_cast<double>(exact),
                  1e-14 * static_cast<double>(std::abs(exact)));
      EXPECT_GE(result.magnitude, std::abs(result.change));
    }
  }
}

// At rest V and V_alpha are so small that their logarithms are large and nearly cancel. The
// magnitude says how far the change may be off, even if V moves by its last digit only.
TEST(Difference, KnowsTheRoundingOfLogarithms)
{
  for (auto const& law : both_laws) {
    for (const double shift : {20.0, 38.4, 300.0, 600.0}) {
      // V* = 1 m/s and a power of two for a: the kernels' shift is exact.
      const ReferenceNode node{{law, 1. / 64, 0, 1, shift / 64}, 1, 256, 1, 1, 0};
      const auto v_alpha = static_cast<double>(node.law.vAlpha(0));
      for (int k = 0; k < 60; ++k) {
        const double V = v_alpha * std::exp(-3 + 6 * (k + 0.3) / 60);
        for (const double ratio : {epsilon, -epsilon, 1e-6, -0.5, 3.0}) {
          const double d = (V + ratio * V) - V;
          Real growth = 0;
          const Real exact = referenceDifference(node, {V, 0}, {d, 0}, growth);
          const auto result = difference(node, {V}, {d});
          EXPECT_LE(std::abs(result.change - exact), 5 * epsilon * result.magnitude)
            << law << " shift=" << shift << " V=" << V << " d=" << d;
        }
      }
    }
  }
}

TEST(Difference, AddsUpOverTheFault)
{
  for (auto const& law : both_laws) {
    const auto nodes = variousNodes(law);
    const Fault fault(nodes);
    std::vector<Values> v, d;
    Real exact = 0;
    double magnitude = 0;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
      v.push_back(scaled(direction(2, i), i % 5 == 0 ? 0 : 1e-3 * i));
      d.push_back(scaled(direction(2, 3 * i), i % 7 == 0 ? 0 : 2e-3));
      Real growth = 0;
      exact += referenceDifference(nodes[i], widened(v[i]), widened(d[i]), growth);
      magnitude += difference(nodes[i], v[i], d[i]).magnitude;
    }
    const auto result = fault.kernels->difference(toDevice(v), toDevice(d), fault.at);
    EXPECT_NEAR(result.change, static_cast<double>(exact), 1e-13 * magnitude);
    EXPECT_NEAR(result.magnitude, magnitude, 1e-14 * magnitude);
  }
}
} // namespace
} // namespace asperity::friction::test
