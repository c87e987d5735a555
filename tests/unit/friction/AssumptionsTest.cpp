#include "friction/laws/AgeingLaw.hpp"
#include "friction/laws/RegularisedLaw.hpp"
#include "friction/laws/SlipLaw.hpp"
#include "friction/laws/TruncatedLaw.hpp"
#include "unit/friction/Reference.hpp"
#include "unit/friction/Views.hpp"

#include <gtest/gtest.h>

#include <random>

// The assumptions of Pipping 2014, §1.3 and §3.3, at random slip rates and states.
namespace asperity::friction::test
{
namespace
{
const auto state = lawWith<StateParameters>({{"L", 2e-5}, {"Reference Slip Rate", 5e-5}});

class Samples
{
public:
  double rate() { return std::exp(uniform(-690, 5)); }
  double alpha() { return uniform(-40, 60); }

private:
  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }

  std::mt19937 generator_{1};
};

template <class Law>
class AssumptionsTest : public ::testing::Test
{
protected:
  const Law law = lawWith<Law>({{"a", 0.01}, {"b", 0.015}});
  Samples samples;
};

using BothLaws = ::testing::Types<RegularisedLaw, TruncatedLaw>;
TYPED_TEST_SUITE(AssumptionsTest, BothLaws);

// (A1)
TYPED_TEST(AssumptionsTest, CoefficientGrowsWithTheSlipRateFromZero)
{
  for (int i = 0; i < 10000; ++i) {
    const auto curve = this->law.at(this->samples.alpha());
    double slow = this->samples.rate(), fast = this->samples.rate();
    if (slow > fast) {
      std::swap(slow, fast);
    }
    EXPECT_EQ(curve.mu(0), 0);
    EXPECT_GE(curve.mu(slow), 0);
    EXPECT_LE(curve.mu(slow), curve.mu(fast));
    EXPECT_LE(curve.mu(slow), curve.mu(slow * (1 + 1e-9)));
  }
}

// (A2), with b for the Lipschitz constant
TYPED_TEST(AssumptionsTest, CoefficientIsLipschitzInTheState)
{
  for (int i = 0; i < 10000; ++i) {
    const double V = this->samples.rate();
    const double alpha = this->samples.alpha(), beta = this->samples.alpha();
    const double change = this->law.at(alpha).mu(V) - this->law.at(beta).mu(V);
    EXPECT_LE(std::abs(change), this->law.b * std::abs(alpha - beta) + 1e-14);
  }
}

// (A3)
TEST(StateAssumptions, RateDoesNotGrowWithTheState)
{
  Samples samples;
  for (int i = 0; i < 10000; ++i) {
    const double V = samples.rate();
    double low = samples.alpha(), high = samples.alpha();
    if (low > high) {
      std::swap(low, high);
    }
    EXPECT_GE(AgeingLaw{state}.rate(V, low), AgeingLaw{state}.rate(V, high));
    EXPECT_GE(SlipLaw{state}.rate(V, low), SlipLaw{state}.rate(V, high));
  }
}

// (A5), with 1 / L for the Lipschitz constant
TEST(StateAssumptions, AgeingRateIsLipschitzInTheSlipRate)
{
  Samples samples;
  const AgeingLaw law{state};
  for (int i = 0; i < 10000; ++i) {
    const double V = samples.rate(), W = samples.rate(), alpha = samples.alpha();
    const double change = std::abs(law.rate(V, alpha) - law.rate(W, alpha));
    const double rounding = epsilon * std::abs(law.rate(0, alpha));
    EXPECT_LE(change, std::abs(V - W) / state.slip_distance * (1 + 4 * epsilon) + 2 * rounding);
  }
}

// d(alpha)/dt is that of the flow map.
template <class Law>
void expectRateOfFlow(Law const& law)
{
  for (const double V : {0.0, 1e-300, 1e-9, 5e-5, 1e-2, 1e2}) {
    for (const double alpha : {-12.0, -2.0, 0.5, 15.0}) {
      const double scale = 1 + std::abs(law.rate(V, alpha));
      const double dt = 1e-6 / scale;
      const double change = law.flow(V, dt, alpha) - alpha;
      EXPECT_NEAR(change / dt, law.rate(V, alpha),
                  1e-5 * (1 + V / state.slip_distance) + 1e-5 * scale)
        << Law::name << ' ' << V << ' ' << alpha;
    }
  }
}

TEST(StateAssumptions, RateIsThatOfTheFlowMap)
{
  expectRateOfFlow(AgeingLaw{state});
  expectRateOfFlow(SlipLaw{state});
}
} // namespace
} // namespace asperity::friction::test
