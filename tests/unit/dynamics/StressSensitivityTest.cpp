#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Linker and Dieterich's term: a change of the normal stress shifts the state.
namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
// At rest for ever: nothing pushes it.
ModelOptions restingBlock()
{
  ModelOptions options;
  options.mesh = fem::test::uniformRectangle(3, 2, 0.3, 0.2);
  return options;
}

// alpha at the end of so many steps of 4 ms 2^-level.
double alphaAfter(ModelOptions const& options, int level, int steps, double alpha0)
{
  const Model model(options, fem::test::selfCommunicator());
  Stepper stepper(model, RateUpdate::newmark(0.25), DyadicTime(4e-3, 8));
  auto state = model.restingState();
  state.alpha = model.nodeView([=](auto const&) { return alpha0; });
  for (int n = 0; n < steps; ++n) {
    auto to = state.clone();
    EXPECT_TRUE(stepper.step.solve(state, level, to, stepper.count).solved());
    state = to;
  }
  return toHost(state.alpha)(1);
}
} // namespace

// The slip law does not change the state of a fault at rest: what is left is the jump.
TEST(StressSensitivity, ShiftsTheStateByAJumpOfTheNormalStress)
{
  auto options = restingBlock();
  options.state_law = "Slip";
  options.stress_sensitivity = 0.3;
  for (double after : {3500., 800.}) {
    options.normal_stress = [after](Point<2> const&, double t) { return t > 0 ? after : 2000.; };
    EXPECT_NEAR(alphaAfter(options, 0, 1, 0.7), 0.7 - 0.3 * std::log(after / 2000), 1e-14);
    EXPECT_NEAR(alphaAfter(options, 0, 3, 0.7), 0.7 - 0.3 * std::log(after / 2000), 1e-14);
  }
  options.stress_sensitivity = 0;
  EXPECT_EQ(alphaAfter(options, 0, 1, 0.7), 0.7);
}

// Ageing at rest with c = b: (theta sigma)' = sigma, hence with sigma = sigma0 (1 + t/T)
//   theta = (theta0 + t + t^2 / (2 T)) / (1 + t/T),   theta = L / V* exp(alpha).
TEST(StressSensitivity, IsSplitToSecondOrder)
{
  const double T = 5e-3;
  auto options = restingBlock();
  options.L = 1e-6;
  options.reference_rate = 1e-3;
  options.stress_sensitivity = 1;
  options.normal_stress = [T](Point<2> const&, double t) { return 2000 * (1 + t / T); };
  const double scale = options.L / options.reference_rate;
  const double alpha0 = 0.5;
  const double t = 8e-3;
  const double theta = (scale * std::exp(alpha0) + t + t * t / (2 * T)) / (1 + t / T);
  const double expected = std::log(theta / scale);
  std::vector<double> errors;
  for (int level : {3, 4, 5, 6}) {
    errors.push_back(std::abs(alphaAfter(options, level, 2 << level, alpha0) - expected));
  }
  EXPECT_LT(errors.back(), 1e-4);
  for (int i : {0, 1, 2}) {
    EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]), 2, 0.1) << i;
  }
}
} // namespace asperity::dynamics
