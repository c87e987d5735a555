#include "friction/laws/RegularisedLaw.hpp"
#include "friction/laws/TruncatedLaw.hpp"
#include "unit/friction/Reference.hpp"
#include "unit/friction/Views.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace asperity::friction::test
{
namespace
{
const std::vector<double> slip_rates{0, 1e-300, 1e-100, 1e-20, 1e-12, 1e-6, 3e-5, 1, 1e2};
const std::vector<double> states{-100, -47.5, -20, -3, 0, 1e-3, 5, 12, 30, 100};

template <class Law>
class CurveTest : public ::testing::Test
{
protected:
  // Wedge, crust, and a pair in which b alpha / a reaches 2000.
  const std::vector<ReferenceLaw> laws{{Law::name, 0.002, 0.014, 5e-5, 0.7},
                                       {Law::name, 0.010, 0.015, 1e-6, 0.6},
                                       {Law::name, 0.001, 0.020, 1e-9, 0.3}};

  static typename Law::Curve curve(ReferenceLaw const& law, double alpha)
  {
    return lawWith<Law>({{"a", law.a},
                         {"b", law.b},
                         {"Reference Slip Rate", law.reference_slip_rate},
                         {"Reference Friction Coefficient", law.reference_friction}})
      .at(alpha);
  }
};

using BothLaws = ::testing::Types<RegularisedLaw, TruncatedLaw>;
TYPED_TEST_SUITE(CurveTest, BothLaws);

TYPED_TEST(CurveTest, CoefficientIsThatOfTheLiterature)
{
  for (auto const& law : this->laws) {
    for (const double alpha : states) {
      const auto curve = this->curve(law, alpha);
      for (const double V : slip_rates) {
        const auto tolerance = static_cast<double>(law.muTolerance(V, alpha));
        EXPECT_NEAR(curve.mu(V), static_cast<double>(law.mu(V, alpha)), tolerance)
          << V << ' ' << alpha;
        EXPECT_EQ(curve.mu(V), V > 0 ? curve.response(V).mu : 0.0);
      }
    }
  }
}

TYPED_TEST(CurveTest, ResponseHoldsTheDerivativesByLogV)
{
  const Real step = 1e-5L; // of log V: the quotients are good to step^2
  for (auto const& law : this->laws) {
    for (const double alpha : states) {
      const auto curve = this->curve(law, alpha);
      for (const double V : slip_rates) {
        if (V == 0 || std::abs(curve.logRatio(V)) < 1e-4) {
          continue; // the quotient would straddle the truncated law's kink
        }
        const Real below = law.mu(V * std::exp(-step), alpha);
        const Real here = law.mu(V, alpha);
        const Real above = law.mu(V * std::exp(step), alpha);
        const auto first = static_cast<double>((above - below) / (2 * step));
        const auto second = static_cast<double>((above - 2 * here + below) / (step * step));
        const double noise = 1e-8 * (first + static_cast<double>(here)) + 1e-300;
        EXPECT_NEAR(curve.response(V).first, first, noise) << V << ' ' << alpha;
        EXPECT_NEAR(curve.response(V).second, second, noise) << V << ' ' << alpha;
      }
    }
  }
}

TYPED_TEST(CurveTest, DerivativeIsRightFromRestToFastSlip)
{
  for (auto const& law : this->laws) {
    for (const double alpha : states) {
      const auto curve = this->curve(law, alpha);
      for (const double V : slip_rates) {
        // Infinite beyond the largest double.
        const auto expected = static_cast<double>(law.derivative(V, alpha));
        if (std::isinf(expected)) {
          EXPECT_EQ(curve.derivative(V), expected);
        } else {
          EXPECT_NEAR(curve.derivative(V), expected, 2e-12 * expected) << V << ' ' << alpha;
        }
      }
    }
  }
}

TYPED_TEST(CurveTest, MeanIsTheIntegralOverTheWidth)
{
  const std::vector<double> ratios{-1,   -0.9, -0.3, -1e-3, -1e-12, 1e-15, 1e-12, 1e-6,
                                   0.05, 0.6,  0.66, 0.99,  1.01,   3,     1e3,   1e9};
  for (auto const& law : this->laws) {
    for (const double alpha : states) {
      const auto curve = this->curve(law, alpha);
      for (const double V : slip_rates) {
        for (const double ratio : ratios) {
          const double h = V == 0 ? std::abs(ratio) : V * ratio;
          const Real exact = law.mean(V, h, alpha);
          const Real tolerance = law.muTolerance(std::max(V, V + h), alpha) + 6 * epsilon * exact;
          EXPECT_NEAR(curve.mean(V, h), static_cast<double>(exact), static_cast<double>(tolerance))
            << law.name << ' ' << V << ' ' << h << ' ' << alpha << ' ' << curve.shift;
        }
        EXPECT_NEAR(curve.mean(V, 0), curve.mu(V), 1e-15 * curve.mu(V));
      }
    }
  }
}

// Where the coefficient is tiny itself nothing but the mean's own rounding is allowed; next to the
// truncated law's kink also that of V + h, an absolute one.
TYPED_TEST(CurveTest, MeanKeepsItsDigitsAroundTheKnee)
{
  const double rounding = std::string(TypeParam::name) == "Truncated" ? 2 * epsilon * 0.01 : 0;
  for (const double V : {0.0, 1e-20, 1e-6, 1e-3, 0.5, 1.0, 1.0 + 1e-9, 2.0, 40.0}) {
    for (const double h : {1e-12, 1e-9, 1e-4, 0.1, 1.0, 30.0}) {
      const typename TypeParam::Curve curve{0.01, 0}; // V_alpha = 1 m/s
      const ReferenceLaw law{TypeParam::name, 0.01, 0, 1, 0};
      const auto exact = static_cast<double>(law.mean(V, h, 0));
      EXPECT_NEAR(curve.mean(V, h), exact, 8 * epsilon * exact + rounding) << V << ' ' << h;
    }
  }
}

TEST(AsinhHalfExp, IsStableFromMinusToPlusTenThousand)
{
  for (Real x = -10000; x <= 10000; x += 12.3456789L) {
    const auto value = static_cast<double>(x);
    const Real exact = std::asinh(std::exp(Real(value)) / 2);
    EXPECT_NEAR(detail::asinhHalfExp(value), static_cast<double>(exact),
                4 * epsilon * static_cast<double>(exact) + 5e-324)
      << value;
  }
  for (double x = -2; x <= 22; x += 0.01) {
    const Real exact = std::asinh(std::exp(Real(x)) / 2);
    EXPECT_NEAR(detail::asinhHalfExp(x), static_cast<double>(exact),
                4 * epsilon * static_cast<double>(exact));
  }
}

TEST(TruncatedLaw, KnowsItsKink)
{
  const auto curve = lawWith<TruncatedLaw>({{"a", 0.01}, {"b", 0.015}}).at(-10);
  const double kink = 1e-6 * std::exp(-(0.6 - 0.15) / 0.01); // V_alpha
  EXPECT_TRUE(curve.kinkedAt(kink));
  EXPECT_FALSE(curve.kinkedAt(kink * (1 + 1e-10)));
  EXPECT_EQ(curve.mu(kink * (1 - 1e-10)), 0);
  EXPECT_GT(curve.mu(kink * (1 + 1e-10)), 0);
}
} // namespace
} // namespace asperity::friction::test
