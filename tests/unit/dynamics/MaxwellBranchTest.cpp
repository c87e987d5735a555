// Bodies whose stress relaxes, without a deck.

#include "unit/dynamics/ShearedLayer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
constexpr double stop = 8;    // s
constexpr double rate = 1e-3; // m/s, of the top until then

// Of the shear strain rate rate / height until `stop` and none after it, for a modulus that relaxes
// with the time t_r: the integral of G exp(-(t - s) / t_r) over the rate.
double relaxingStress(double modulus, double t_r, double t)
{
  const double since = std::max(0., t - stop);
  return modulus * rate / ShearedLayer::height * t_r * -std::expm1((since - t) / t_r) *
         std::exp(-since / t_r);
}
} // namespace

// A step with a constant strain rate is exact, however long compared with the relaxation times.
TEST(MaxwellBranches, GiveTheStressOfAConstantStrainRate)
{
  for (double time : {0.05, 3., 1e6}) {
    auto options = ShearedLayer::options([](double t) { return t <= stop ? rate : 0; });
    options.relaxation = {{0.25, time}, {0.4, 20 * time}};
    const double G = options.material.shear_modulus, lasting = 0.35 * G;
    ShearedLayer layer(options);
    for (int level : {0, 3, 3, 2, 1, 1, 4, 4, 3, 2, 0, 1}) {
      const double t = layer.advance(level);
      const double expected = lasting * rate * std::min(t, stop) / ShearedLayer::height +
                              relaxingStress(0.25 * G, time, t) +
                              relaxingStress(0.4 * G, 20 * time, t);
      EXPECT_NEAR(layer.stressAtTop(), expected, 1e-11 * G * rate * stop / ShearedLayer::height)
        << time << ' ' << t;
    }
    auto const& energy = layer.balance.energy();
    EXPECT_NEAR(energy.elastic + energy.viscous_work, energy.boundary_work,
                1e-12 * energy.boundary_work);
    EXPECT_NEAR(energy.defect, 0, 1e-12 * energy.boundary_work);
  }
}

// With inertia, friction, viscosity and gravity in addition, whatever the steps.
TEST(MaxwellBranches, TakeTheEnergyThatLeavesTheBody)
{
  for (int components : {1, 2}) {
    auto options = slidingBlock(components);
    options.relaxation = {{0.3, 2e-3}, {0.6, 0.1}};
    const dynamics::test::Model model(options, fem::test::selfCommunicator());
    auto const energy = energyOfSteps(model, slidingState(model));
    EXPECT_NEAR(energy.defect, 0, 1e-10 * energy.friction_work);
    EXPECT_GT(energy.viscous_work, 0);
  }
}
} // namespace asperity::dynamics
