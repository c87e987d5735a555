// Bodies whose stress relaxes, without a deck.

#include "dynamics/observables/EnergyBalance.hpp"
#include "unit/dynamics/QuasiDynamicModel.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::dynamics
{
using namespace testing;

namespace
{
constexpr double height = 0.3, width = 0.4; // m
constexpr double stop = 8;                  // s
constexpr double rate = 1e-3;               // m/s, of the top until then

// Antiplane, on a base that does not slip.
ModelOptions shearedLayer()
{
  ModelOptions options;
  options.components = 1;
  options.mesh = fem::testing::uniformRectangle(4, 3, width, height);
  fem::testing::distort(options.mesh, 0.02);
  options.material = {900, 0.05e6, 0.023e6, 0, 0};
  options.sigma_n = 1e9;
  auto const drive = [](auto const&, double t) { return t <= stop ? rate : 0; };
  options.conditions = {{"Drive", "top", fem::PrescribedVelocity<2>{{1}, drive}}};
  return options;
}

// Of the shear strain rate rate / height until `stop` and none after it, for a modulus that relaxes
// with the time t_r: the integral of G exp(-(t - s) / t_r) over the rate.
double relaxingStress(double modulus, double t_r, double t)
{
  const double since = std::max(0., t - stop);
  return modulus * rate / height * t_r * -std::expm1((since - t) / t_r) * std::exp(-since / t_r);
}
} // namespace

// A step with a constant strain rate is exact, however long beside the relaxation times.
TEST(MaxwellBranches, GiveTheStressOfAConstantStrainRate)
{
  for (double time : {0.05, 3., 1e6}) {
    auto options = shearedLayer();
    options.relaxation = {{0.25, time}, {0.4, 20 * time}};
    const testing::Model model(options, fem::testing::selfCommunicator());
    auto const body = quasiDynamic(model);
    const DyadicTime clock(4, 4);
    CoupledStep step(body.body, body.fault, RateUpdate::backwardEuler(), clock, tightCoupling(),
                     tightSettings(), 1u << 30);
    EnergyBalance balance(body.body, body.fault, clock);
    auto state = body.initial.clone();
    Tpetra::deep_copy(*state.u, *body.body.vector());
    balance.start(state);
    SolveCount count;
    auto forces = body.body.noForces();
    for (int level : {0, 3, 3, 2, 1, 1, 4, 4, 3, 2, 0, 1}) {
      auto next = state.clone();
      ASSERT_TRUE(step.solve(state, level, next, count).solved());
      state = next;
      balance.advance(state);

      const double t = clock.seconds(state.time);
      const double G = options.material.shear_modulus;
      const double expected = 0.35 * G * rate * std::min(t, stop) / height +
                              relaxingStress(0.25 * G, time, t) +
                              relaxingStress(0.4 * G, 20 * time, t);
      body.body.computeForces(state.motion(), forces);
      double pull = 0; // of the top, N/m
      for (int dof : body.body.held.owned()) {
        pull += denseOf(*forces.elastic)[dof];
      }
      EXPECT_NEAR(pull / width, expected, 1e-11 * G * rate * stop / height) << time << ' ' << t;
    }
    auto const& energy = balance.energy();
    EXPECT_NEAR(energy.elastic + energy.viscous_work, energy.boundary_work,
                1e-12 * energy.boundary_work);
    EXPECT_NEAR(energy.defect, 0, 1e-12 * energy.boundary_work);
  }
}

// With inertia, friction, viscosity and gravity beside them, whatever the steps.
TEST(MaxwellBranches, TakeTheEnergyThatLeavesTheBody)
{
  for (int components : {1, 2}) {
    auto options = slidingBlock(components);
    options.relaxation = {{0.3, 2e-3}, {0.6, 0.1}};
    const testing::Model model(options, fem::testing::selfCommunicator());
    auto const energy = energyOfSteps(model, slidingState(model));
    EXPECT_NEAR(energy.defect, 0, 1e-10 * energy.friction_work);
    EXPECT_GT(energy.viscous_work, 0);
  }
}
} // namespace asperity::dynamics
