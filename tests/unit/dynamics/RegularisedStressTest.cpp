#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

// The normal stress of Prakash and Clifton: s' = (V / L + 1 / T) (sigma - s).
namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
constexpr double never = std::numeric_limits<double>::infinity();
char const* const field_name = "regularised_normal_stress";

// At rest for ever, under a normal stress that changes in time.
ModelOptions pressedBlock(std::function<double(double)> const& sigma, double L, double T)
{
  ModelOptions options;
  options.mesh = fem::test::uniformRectangle(3, 2, 0.3, 0.2);
  options.normal_stress = [sigma](Point<2> const&, double t) { return sigma(t); };
  options.regularisation = {L, T};
  return options;
}

// s at the ends of steps of 4 ms 2^-level.
std::vector<double> stressOfSteps(ModelOptions const& options, std::vector<int> const& levels)
{
  const Model model(options, fem::test::selfCommunicator());
  Stepper stepper(model, RateUpdate::newmark(0.25), DyadicTime(4e-3, 8));
  auto state = model.restingState();
  std::vector<double> result;
  for (const int level : levels) {
    auto to = state.clone();
    EXPECT_TRUE(stepper.step.solve(state, level, to, stepper.count).solved());
    state = to;
    result.push_back(toHost(state.at(field_name))(1));
  }
  return result;
}
} // namespace

// A step of sigma is a ramp over the first time step, and constant from there on.
TEST(RegularisedStress, FollowsAStepExponentially)
{
  const double before = 2000, after = 800, tau = 4e-3;
  auto const sigma = [=](double t) { return t > 0 ? after : before; };
  for (double T : {3e-5, 1e-3, 7e-3, 5., 1e7}) {
    auto const s = stressOfSteps(pressedBlock(sigma, never, T), {0, 0, 1, 3, 0});
    const double left = (before - after) * T / tau * -std::expm1(-tau / T);
    double t = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      EXPECT_NEAR(s[i], after + left * std::exp(-t / T), 1e-10) << T << ", step " << i;
      t += i == 1 ? tau / 2 : i == 2 ? tau / 8 : tau;
    }
  }
}

// Of sigma = sigma_0 + r t it has the exact answer, s = sigma - r T (1 - e^(-t / T)), in any steps;
// with T = 0 that is sigma, to the last digits.
TEST(RegularisedStress, IsExactUnderARamp)
{
  const double start = 2000, rate = 5e5;
  auto const sigma = [=](double t) { return start + rate * t; };
  for (double T : {1e-300, 1e-12, 1e-3, 7e-3, 1e9}) {
    double t = 0;
    const std::vector<int> levels = {0, 5, 0, 2, 8};
    auto const s = stressOfSteps(pressedBlock(sigma, never, T), levels);
    for (std::size_t i = 0; i < s.size(); ++i) {
      t += std::ldexp(4e-3, -levels[i]);
      EXPECT_NEAR(s[i] / (sigma(t) + rate * T * std::expm1(-t / T)), 1, 1e-12) << T << ", " << i;
    }
  }
}

// It rests to the last digit where sigma does; and slip alone does nothing at rest.
TEST(RegularisedStress, RestsWhereTheStressRests)
{
  auto const constant = [](double) { return 1234.5678901234567; };
  for (double s : stressOfSteps(pressedBlock(constant, 1e-6, 1e-3), {0, 3, 1, 0, 7})) {
    EXPECT_EQ(s, constant(0));
  }
  auto const falling = [](double t) { return 2000 * std::exp(-100 * t); };
  for (double s : stressOfSteps(pressedBlock(falling, 1e-9, never), {0, 0, 0})) {
    EXPECT_EQ(s, 2000);
  }
}

// Sliding, with the mean slip rate of the step; and stress that falls to zero leaves it above.
TEST(RegularisedStress, FollowsWithSlip)
{
  const double L = 4e-6, T = 9e-3;
  auto options = slidingBlock(2);
  options.cohesion = 20;
  options.normal_stress = [](Point<2> const& x, double t) {
    return std::max(0., 2000 * (1 + x[0] - 150 * t));
  };
  options.regularisation = {L, T};
  const Model model(options, fem::test::selfCommunicator());
  Stepper stepper(model, RateUpdate::newmark(0.25), DyadicTime(4e-3, 4));
  auto state = slidingState(model);
  double slid = 0;
  for (const int level : {2, 1, 3, 2}) {
    auto to = state.clone();
    ASSERT_TRUE(stepper.step.solve(state, level, to, stepper.count).solved());
    auto const s0 = toHost(state.at(field_name)), s1 = toHost(to.at(field_name));
    auto const sigma0 = toHost(state.sigma_n), sigma1 = toHost(to.sigma_n);
    const double tau = std::ldexp(4e-3, -level);
    for (int i = 0; i < model.surface->numNodes(); ++i) {
      const int dof = (*model.surface)[i].dofs.front();
      const double slip = std::abs(to.u->getData()[dof] - state.u->getData()[dof]);
      const double x = slip / L + tau / T;
      const double exact = sigma1(i) + (s0(i) - sigma0(i)) * std::exp(-x) +
                           (sigma1(i) - sigma0(i)) * std::expm1(-x) / x;
      EXPECT_NEAR(s1(i), exact, 1e-6) << i;
      EXPECT_GT(s1(i), 0);
      slid = std::max(slid, slip / L);
    }
    state = to;
  }
  EXPECT_GT(slid, 0.1);
}

// Friction works with s: it is s that balances momentum.
TEST(RegularisedStress, KeepsTheBalanceOfEnergy)
{
  auto options = slidingBlock(2);
  options.normal_stress = [](Point<2> const& x, double t) {
    return 2000 * (1 + x[0]) * (1 + 0.3 * std::sin(200 * t));
  };
  options.regularisation = {5e-6, 3e-3};
  const Model model(options, fem::test::selfCommunicator());
  auto const energy = energyOfSteps(model, slidingState(model));
  EXPECT_GT(energy.friction_work, 0);
  EXPECT_NEAR(energy.defect, 0, 1e-9 * energy.friction_work);
}
} // namespace asperity::dynamics
