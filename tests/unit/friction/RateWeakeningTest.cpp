#include "friction/laws/RateWeakening.hpp"
#include "friction/laws/RegularisedLaw.hpp"
#include "friction/laws/SlipLaw.hpp"
#include "unit/friction/Reference.hpp"
#include "unit/friction/Views.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace asperity::friction::test
{
namespace
{
// SCEC's TPV103 and TPV104: in the middle of the fault, and where friction strengthens.
struct Rock
{
  double a, weakening_rate;
};
const std::vector<Rock> rocks{{0.01, 0.1}, {0.02, 1}};
constexpr double b = 0.014, L = 0.4, reference_rate = 1e-6, reference_friction = 0.6;
constexpr double weakened_friction = 0.2;

template <class Law>
Law lawOf(Rock const& rock)
{
  return lawWith<Law>({{"a", rock.a},
                       {"b", b},
                       {"L", L},
                       {"Reference Slip Rate", reference_rate},
                       {"Reference Friction Coefficient", reference_friction},
                       {"Weakened Friction Coefficient", weakened_friction},
                       {"Weakening Slip Rate", rock.weakening_rate}});
}

RegularisedLaw frictionOf(Rock const& rock)
{
  return lawWith<RegularisedLaw>({{"a", rock.a},
                                  {"b", b},
                                  {"Reference Slip Rate", reference_rate},
                                  {"Reference Friction Coefficient", reference_friction}});
}

Real shareOf(StrongRateWeakeningLaw const&, Real ratio)
{
  return std::pow(1 + std::pow(ratio, Real(8)), Real(-1) / 8);
}

Real shareOf(FlashHeatingLaw const&, Real ratio) { return std::min(Real(1), 1 / ratio); }

// psi_ss = a ln[(2 V* / V) sinh(f_ss / a)] as it is published, with f_LV = f* - (b - a) ln(V / V*).
template <class Law>
Real steadyPsi(Law const& law, Rock const& rock, Real V)
{
  const Real x = std::log(V / reference_rate);
  const Real slow = reference_friction - (Real(b) - rock.a) * x;
  const Real f =
    weakened_friction + (slow - weakened_friction) * shareOf(law, V / rock.weakening_rate);
  return rock.a * std::log(2 / (V / Real(reference_rate)) * std::sinh(f / rock.a));
}

template <class Law>
class RateWeakeningTest : public ::testing::Test
{
};
using BothLaws = ::testing::Types<StrongRateWeakeningLaw, FlashHeatingLaw>;
TYPED_TEST_SUITE(RateWeakeningTest, BothLaws);

TYPED_TEST(RateWeakeningTest, SteadyStateIsThePublishedOne)
{
  for (auto const& rock : rocks) {
    const auto law = lawOf<TypeParam>(rock);
    for (const double V : {1e-16, 1e-12, 1e-9, 1e-6, 1e-3, 0.03, 0.1, 0.2, 1.0, 3.0, 30.0}) {
      const Real psi = steadyPsi(law, rock, V);
      EXPECT_NEAR(reference_friction + b * law.steadyState(V), static_cast<double>(psi), 1e-14)
        << V;
    }
  }
}

TYPED_TEST(RateWeakeningTest, FrictionFallsToTheWeakenedCoefficient)
{
  for (auto const& rock : rocks) {
    const auto law = lawOf<TypeParam>(rock);
    const double V = 1e4;
    const double mu = frictionOf(rock).at(law.steadyState(V)).mu(V);
    EXPECT_NEAR(mu, weakened_friction, 0.01 * weakened_friction);
    EXPECT_GT(mu, weakened_friction);
  }
}

// Where f* - (b - a) ln(V / V*) would be negative there is still a state.
TYPED_TEST(RateWeakeningTest, IsTheSlipLawFarBelowTheWeakeningSlipRate)
{
  for (auto const& rock : rocks) {
    const auto law = lawOf<TypeParam>(rock);
    const auto slip = lawWith<SlipLaw>({{"L", L}, {"Reference Slip Rate", reference_rate}});
    for (const double V : {0.0, 1e-300, 1e-200, 1e-60, 1e-16, 1e-9, 1e-5}) {
      EXPECT_EQ(law.steadyState(V), slip.steadyState(V));
      EXPECT_EQ(law.flow(V, 1e3, 17), slip.flow(V, 1e3, 17));
      EXPECT_EQ(law.rate(V, 17), slip.rate(V, 17));
    }
  }
}

TYPED_TEST(RateWeakeningTest, FlowIsExactAtConstantSlipRate)
{
  for (auto const& rock : rocks) {
    const auto law = lawOf<TypeParam>(rock);
    for (const double V : {1e-16, 1e-6, 0.2, 5.0}) {
      for (const double dt : {0.0, 1e-6, 0.01, 1.0, 1e6}) {
        const Real steady = (steadyPsi(law, rock, V) - reference_friction) / b;
        for (const double alpha : {-40.0, -2.6, 0.0, 25.0}) {
          const Real exact = steady + (alpha - steady) * std::exp(-Real(V) * dt / L);
          EXPECT_NEAR(law.flow(V, dt, alpha), static_cast<double>(exact), 2e-12) << V << ' ' << dt;
        }
      }
    }
  }
}

TYPED_TEST(RateWeakeningTest, RateIsThatOfTheFlow)
{
  const auto law = lawOf<TypeParam>(rocks[0]);
  for (const double V : {1e-9, 1e-3, 0.3, 5.0}) {
    const double dt = 1e-6 * L / V, alpha = -3;
    const double rate = law.rate(V, alpha);
    EXPECT_NEAR((law.flow(V, dt, alpha) - alpha) / dt, rate, 2e-6 * std::abs(rate));
  }
}

// TPV103 begins at 1e-16 m/s with 40 MPa under 120 MPa, which is psi = 0.5635918.
TEST(StrongRateWeakening, BeginsWithThePublishedState)
{
  const double alpha = frictionOf(rocks[0]).stateFor(1e-16, 40.0 / 120);
  EXPECT_NEAR(reference_friction + b * alpha, 0.5635918, 5e-8);
}
} // namespace
} // namespace asperity::friction::test
