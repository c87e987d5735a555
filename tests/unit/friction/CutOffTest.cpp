#include "friction/laws/CutOffLaw.hpp"

#include "unit/friction/Reference.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace asperity::friction::test
{
namespace
{
constexpr double a = 0.01, b = 0.015, cut_off = 1e-4, reference_friction = 0.6;
const CutOffLaw law{a, b, cut_off, reference_friction};
const std::vector<double> slip_rates{0, 1e-300, 1e-20, 1e-12, 1e-6, 1e-4, 0.3, 1e2};
const std::vector<double> states{-45, -39.9, -20, 0, 12, 60};

Real reference(Real V, double alpha)
{
  return V == 0 ? 0
                : std::max(Real(0), reference_friction + Real(b) * alpha -
                                      a * std::log1p(Real(cut_off) / V));
}

Real kink(double alpha) { return cut_off / std::expm1((reference_friction + Real(b) * alpha) / a); }

// By tanh-sinh quadrature between the kink, if it lies inside, and the end.
Real meanOf(Real V, Real h, double alpha)
{
  const Real low = std::min(V, V + h), high = std::max(V, V + h);
  const Real start = kink(alpha) > 0 ? std::max(low, kink(alpha)) : high;
  if (start >= high) {
    return 0;
  }
  Real sum = 0;
  const Real half_pi = std::acos(Real(-1)) / 2, step = Real(1) / 32;
  for (int k = -140; k <= 140; ++k) {
    const Real t = k * step;
    const Real fraction = 1 / (1 + std::exp(-2 * half_pi * std::sinh(t)));
    const Real cosh = std::cosh(half_pi * std::sinh(t));
    sum += half_pi * std::cosh(t) / (2 * cosh * cosh) *
           reference(start + (high - start) * fraction, alpha);
  }
  return sum * step * (high - start) / (high - low);
}

double rounding(double V) // of mu
{
  const double digits = V > 0 ? std::abs(std::log(V)) : 0;
  return 4 * epsilon * (2 + a * (digits + 10));
}

TEST(CutOffLaw, CoefficientAndItsDerivatives)
{
  for (const double alpha : states) {
    const auto curve = law.at(alpha);
    EXPECT_EQ(curve.mu(0), 0);
    for (const double V : slip_rates) {
      EXPECT_NEAR(curve.mu(V), static_cast<double>(reference(V, alpha)), rounding(V));
      if (V == 0 || std::abs(V / static_cast<double>(kink(alpha)) - 1) < 1e-3) {
        continue;
      }
      const Real e = 1e-5L;
      const Real below = reference(V * std::exp(-e), alpha), here = reference(V, alpha);
      const Real above = reference(V * std::exp(e), alpha);
      const auto response = curve.response(V);
      EXPECT_EQ(response.mu, curve.mu(V));
      EXPECT_NEAR(response.first, static_cast<double>((above - below) / (2 * e)), 1e-10);
      EXPECT_NEAR(response.second, static_cast<double>((above - 2 * here + below) / (e * e)), 1e-8);
      EXPECT_NEAR(curve.derivative(V) * V, response.first, 1e-14);
    }
  }
}

TEST(CutOffLaw, MeanIsTheIntegralOverTheWidth)
{
  for (const double alpha : states) {
    const auto curve = law.at(alpha);
    for (const double V : slip_rates) {
      for (const double ratio : {-1., -0.5, -1e-6, 1e-9, 0.01, 0.6, 0.7, 3., 1e6}) {
        const double h = V == 0 ? std::abs(ratio) : V * ratio;
        EXPECT_NEAR(curve.mean(V, h), static_cast<double>(meanOf(V, h, alpha)),
                    4 * rounding(std::max(V, V + h)))
          << V << ' ' << h << ' ' << alpha;
      }
      EXPECT_EQ(curve.mean(V, 0), curve.mu(V));
    }
  }
}

TEST(CutOffLaw, KnowsItsKinkAndItsState)
{
  const auto curve = law.at(-20);
  const auto V = static_cast<double>(kink(-20));
  EXPECT_TRUE(curve.kinkedAt(V));
  EXPECT_FALSE(curve.kinkedAt(1.001 * V));
  EXPECT_EQ(curve.mu(0.999 * V), 0);
  EXPECT_NEAR(law.stateFor(1e-6, law.at(3).mu(1e-6)), 3, 1e-12);
}

// Above the cut-off the state alone decides.
TEST(CutOffLaw, HasNoDirectEffectAtHighSlipRates)
{
  EXPECT_NEAR(law.at(-10).mu(100), reference_friction - 10 * b, 2e-8);
}
} // namespace
} // namespace asperity::friction::test
