#include "unit/friction/Fault.hpp"

#include <gtest/gtest.h>

namespace asperity::friction::test
{
namespace
{
double slope(ReferenceNode const& node, Values const& v, Values const& d, double t)
{
  const Fault fault({node});
  return fault.kernels->slope(toDevice(std::vector<Values>{v}), toDevice(std::vector<Values>{d}), t,
                              fault.at);
}

TEST(Slope, IsGradientTimesDirectionAwayFromRest)
{
  for (auto const& law : both_laws) {
    for (auto const& node : variousNodes(law)) {
      for (const int T : {1, 2}) {
        for (const double length : {1e-300, 1e-20, 1e-6, 1.0, 1e2}) {
          for (const double t : {0.0, 0.25, 3.0}) {
            const Values v = scaled(direction(T, 0), length), d = scaled(direction(T, 5), length);
            Vector2 w = widened(v);
            const Vector2 step = widened(d);
            w = {w[0] + t * step[0], w[1] + t * step[1]};
            const Real s = norm(w);
            const Real exact = node.force(s) * (w[0] * step[0] + w[1] * step[1]) / s;
            const Real tolerance = 4 * node.forceTolerance(s) * norm(step) + 1e-320L;
            EXPECT_LE(std::abs(slope(node, v, d, t) - exact), tolerance)
              << law << " T=" << T << ' ' << length << ' ' << t << " alpha=" << node.alpha;
          }
        }
      }
    }
  }
}

TEST(Slope, IsOneSidedAtRest)
{
  for (auto const& law : both_laws) {
    const ReferenceNode node{{law, 0.01, 0.015, 1e-6, 0.6}, 3, 1e6, 40, 2, 1};
    EXPECT_DOUBLE_EQ(slope(node, {0}, {-0.5}, 0), 120 * 0.5);
    EXPECT_DOUBLE_EQ(slope(node, {0, 0}, {0.3, -0.4}, 0), 120 * 0.5);
    // Through rest: downhill before, uphill at it and after it.
    EXPECT_LT(slope(node, {0.25, 0.5}, {-0.5, -1}, 0.4999), -120 * std::hypot(0.5, 1));
    EXPECT_DOUBLE_EQ(slope(node, {0.25, 0.5}, {-0.5, -1}, 0.5), 120 * std::hypot(0.5, 1));
    EXPECT_GT(slope(node, {0.25, 0.5}, {-0.5, -1}, 0.5001), 120 * std::hypot(0.5, 1));
    EXPECT_EQ(slope(node, {0, 0}, {0, 0}, 1), 0);
  }
}

TEST(Slope, GrowsAlongEveryLine)
{
  for (auto const& law : both_laws) {
    const auto nodes = variousNodes(law);
    const Fault fault(nodes);
    std::vector<Values> v, d;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
      v.push_back(scaled(direction(2, i), 1e-3 * (i % 9)));
      d.push_back(scaled(direction(2, 3 * i), -2e-3 * (i % 4)));
    }
    const auto rates = toDevice(v), steps = toDevice(d);
    double previous = -std::numeric_limits<double>::infinity();
    for (double t = 0; t < 5; t += 0.125) {
      const double here = fault.kernels->slope(rates, steps, t, fault.at);
      EXPECT_GE(here, previous - 1e-12 * std::abs(previous)) << law << ' ' << t;
      previous = here;
    }
  }
}
} // namespace
} // namespace asperity::friction::test
