#include "friction/Registry.hpp"
#include "unit/friction/Views.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Velocity steps, holds and steady sliding at a prescribed slip rate, against closed forms.
namespace asperity::friction::test
{
namespace
{
constexpr double a = 0.010, b = 0.015, L = 1e-5, reference_rate = 1e-6, reference_friction = 0.6;

// One node with a friction law and a state law, driven at prescribed slip rates.
class Slider
{
public:
  Slider(std::string const& law, std::string const& evolution)
      : friction_(makeFrictionKernels(
          law, {unit_, unit_, unit_, parametersOf({{a, b, reference_rate, reference_friction}})}))
      , state_(makeStateKernels(evolution, parametersOf({{L, reference_rate, 0.}})))
  {
  }

  void slideSteadily(double V) { state_->steadyState(toDevice(Values{V}), alpha_); }

  void slide(double V, double duration)
  {
    EXPECT_EQ(state_->flow(toDevice(Values{V}), duration, alpha_, alpha_), 0);
  }

  double friction(double V) const
  {
    const NodeView mu("mu", 1);
    friction_->coefficient(toDevice(std::vector<Values>{{V}}), alpha_, mu);
    return toHost(mu)(0);
  }

  double theta() const { return L / reference_rate * std::exp(toHost(alpha_)(0)); }

private:
  NodeView unit_ = toDevice(Values{1});
  NodeView alpha_ = toDevice(Values{0});
  std::unique_ptr<FrictionKernels> friction_;
  std::unique_ptr<StateKernels> state_;
};

TEST(FrictionKernel, SteadySliding)
{
  for (auto const* evolution : {"Ageing", "Slip"}) {
    for (const double V : {1e-14, 1e-9, 1e-6, 1e-3, 1e2}) {
      Slider regularised("Regularised", evolution), truncated("Truncated", evolution);
      regularised.slideSteadily(V);
      truncated.slideSteadily(V);
      const double exponent = (reference_friction + b * std::log(reference_rate / V)) / a;
      const double exact = a * std::asinh(V / (2 * reference_rate) * std::exp(exponent));
      const double logarithmic = reference_friction + (a - b) * std::log(V / reference_rate);
      EXPECT_NEAR(regularised.friction(V), exact, 1e-13);
      EXPECT_NEAR(truncated.friction(V), logarithmic, 1e-13);
      EXPECT_NEAR(regularised.friction(V), logarithmic, 1e-9);
    }
  }
}

// From steady sliding at V1 the rate is stepped to V2; slip is the distance since.
TEST(FrictionKernel, VelocityStep)
{
  for (const double V1 : {1e-9, 1e-6, 1e-2}) {
    for (const double V2 : {1e-8, 1e-6, 1.0}) {
      Slider slip_law("Truncated", "Slip"), ageing_law("Truncated", "Ageing");
      slip_law.slideSteadily(V1);
      ageing_law.slideSteadily(V1);
      const double direct_effect = slip_law.friction(V2) - slip_law.friction(V1);
      EXPECT_NEAR(direct_effect, a * std::log(V2 / V1), 1e-13);
      double slip = 0;
      for (const double distance : {1e-9, 1e-7, 1e-6, 5e-6, 1e-5, 4e-5, 1e-3}) {
        slip += distance;
        slip_law.slide(V2, distance / V2);
        ageing_law.slide(V2, distance / V2);
        const double decay = std::exp(-slip / L);
        EXPECT_NEAR(std::log(V2 * slip_law.theta() / L), std::log(V2 / V1) * decay, 1e-12);
        const double ageing = 1 + (V2 / V1 - 1) * decay;
        EXPECT_NEAR(V2 * ageing_law.theta() / L, ageing, 1e-12 * ageing);
        const double steady = reference_friction + (a - b) * std::log(V2 / reference_rate);
        EXPECT_NEAR(slip_law.friction(V2), steady + b * std::log(V2 / V1) * decay, 1e-12);
      }
    }
  }
}

TEST(FrictionKernel, Hold)
{
  Slider slip_law("Regularised", "Slip"), ageing_law("Regularised", "Ageing");
  slip_law.slideSteadily(1e-6);
  ageing_law.slideSteadily(1e-6);
  double time = 0;
  for (const double duration : {1e-6, 1e-3, 1.0, 1e2, 1e5, 3e9}) {
    time += duration;
    slip_law.slide(0, duration);
    ageing_law.slide(0, duration);
    EXPECT_DOUBLE_EQ(slip_law.theta(), L / 1e-6);
    EXPECT_NEAR(ageing_law.theta(), L / 1e-6 + time, 1e-13 * ageing_law.theta());
  }
}

TEST(FrictionKernel, ConstantSlipRate)
{
  for (const double V : {1e-12, 1e-6, 1e-3}) {
    for (const double dt : {1e-3, 1.0, 50.0}) {
      Slider slip_law("Regularised", "Slip"), ageing_law("Regularised", "Ageing");
      const double theta0 = slip_law.theta();
      slip_law.slide(V, dt);
      ageing_law.slide(V, dt);
      const double q = V * dt / L;
      EXPECT_NEAR(ageing_law.theta() / (theta0 * std::exp(-q) - L / V * std::expm1(-q)), 1, 1e-13);
      EXPECT_NEAR(slip_law.theta() / (L / V * std::pow(V * theta0 / L, std::exp(-q))), 1, 1e-12);
    }
  }
}
} // namespace
} // namespace asperity::friction::test
