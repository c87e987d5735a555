// Bodies whose rock yields, without a deck.

#include "fem/inelastic/InelasticCells.hpp"
#include "unit/dynamics/ShearedLayer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
constexpr double there = 8, rate = 1e-3;          // s; m/s, of the top: there, then back
constexpr double strength = 300, hardening = 2e3; // Pa

ModelOptions yieldingLayer()
{
  auto options = ShearedLayer::options([](double t) { return t <= there ? rate : -rate; });
  options.yield = "Von Mises";
  options.strength = {strength, hardening, 0, 1, 1, 0, 0};
  return options;
}

// The stress of a shear strain `change` after one that left `stress` and the accumulated inelastic
// shear `gamma`, which it updates. Exact for any monotone change.
double sheared(double change, double G, double& stress, double& gamma)
{
  const double trial = stress + G * change;
  const double over = std::abs(trial) - strength - hardening * gamma;
  const double yielded = over > 0 ? over / (G + hardening) : 0;
  gamma += yielded;
  stress = trial - std::copysign(G * yielded, trial);
  return stress;
}
} // namespace

// Loading, unloading and yielding in the other direction; the energy goes where the stress says.
TEST(Yield, GivesTheStressOfAShearedLayer)
{
  auto const options = yieldingLayer();
  const double G = options.material.shear_modulus;
  ShearedLayer layer(options);
  double stress = 0, gamma = 0, work = 0;
  for (int level : {1, 2, 3, 4, 4, 1, 1, 0, 0, 2, 1, 0, 0}) {
    const double t = layer.advance(level), tau = layer.clock.stepSize(level);
    const double before = stress, gamma_before = gamma;
    sheared((t <= there ? rate : -rate) * tau / ShearedLayer::height, G, stress, gamma);
    work += ShearedLayer::width * ShearedLayer::height * (gamma - gamma_before) *
            std::abs(before + stress) / 2;
    EXPECT_NEAR(layer.stressAtTop(), stress, 1e-10 * strength) << t;
    auto const shear = toHost(layer.state.inelastic->shear);
    for (int cell = 0; cell < shear.extent_int(0); ++cell) {
      EXPECT_NEAR(shear(cell, 0), gamma, 1e-10 * strength / G);
    }
  }
  ASSERT_GT(gamma, 0.03);
  auto const& energy = layer.balance.energy();
  EXPECT_NEAR(energy.inelastic_work, work, 1e-9 * work);
  EXPECT_NEAR(energy.defect, 0, 1e-9 * work);
  EXPECT_EQ(layer.count.energy_increases, 0);
}

// With inertia, friction, viscosity and gravity in addition, whatever the steps, in all dimensions.
// The rock below was weakened until a thousandth of the friction work is inelastic.
template <class Options, class Begin>
void expectClosedBalance(Options options, Begin const& begin, std::string const& law,
                         std::vector<double> const& of_rock)
{
  options.yield = law;
  options.strength = of_rock;
  const ModelIn model(options, fem::test::selfCommunicator());
  auto const energy = energyOfSteps(model, begin(model));
  EXPECT_NEAR(energy.defect, 0, 1e-8 * energy.friction_work);
  EXPECT_GT(energy.inelastic_work, 1e-3 * energy.friction_work);
}

TEST(Yield, TakesTheEnergyThatLeavesTheBody)
{
  const auto begin = [](auto const& model) { return slidingState(model); };
  expectClosedBalance(slidingBlock(1), begin, "Von Mises", {0.3, 0, 0, 1, 1, 0, 0});
  expectClosedBalance(slidingBlock(2), begin, "Von Mises", {0.5, 50, 1e-3, 1, 1, 0, 0});
  expectClosedBalance(slidingBlock(2), begin, "Drucker-Prager", {0.5, 20, 0, 0, 1, 1, 0, 0, 0});
  expectClosedBalance(slidingBlock(2), begin, "Drucker-Prager",
                      {0.5, 20, 0, 0, 0.5, 1e-3, 0, 0, 0});
  expectClosedBalance(slidingBlock(2), begin, "Drucker-Prager", {0.5, 20, 0, 0, 1, 1, 20, 0, 0});
  expectClosedBalance(slidingBlock(2), begin, "Power Law", {1e-3, 3});
}

TEST(Yield, TakesTheEnergyThatLeavesABlockInSpace)
{
  auto const turn = fem::test::rotationAbout({1, 2, 3}, 0.7);
  const auto begin = [&](auto const& model) { return slidingState(model, turn); };
  expectClosedBalance(slidingBlockInSpace({4, 2, 2}, turn), begin, "Von Mises",
                      {0.5, 0, 0, 1, 1, 0, 0});
  expectClosedBalance(slidingBlockInSpace({4, 2, 2}, turn), begin, "Drucker-Prager",
                      {0.5, 20, 0, 0, 1, 1, 20, 0, 0});
}

// The strain of cells is in the error that step controls see.
TEST(Yield, CountsWhereStatesAreCompared)
{
  ShearedLayer layer(yieldingLayer());
  layer.advance(0);
  layer.advance(0);
  auto const other = layer.state.clone();
  EXPECT_EQ(layer.step.distance(layer.state, other, Norm::maximum), 0);
  Kokkos::deep_copy(other.inelastic->strain, 0.);
  const double found = layer.step.distance(layer.state, other, Norm::maximum);
  EXPECT_GT(found, 0.01);
  EXPECT_EQ(found, layer.body.body.cells->distance(layer.state.inelastic->strain,
                                                   other.inelastic->strain, true));
}

// A block that yields does not bear the stress of a static start.
TEST(Yield, NamesTheCellThatCannotBearItsStress)
{
  auto options = yieldingLayer();
  options.initial_stress = {0, 250};
  const dynamics::test::Model model(options, fem::test::selfCommunicator());
  auto const u = model.body.vector();
  EXPECT_FALSE(model.body.cells->largestExcess(*u));
  const double gamma = 100 / options.material.shear_modulus;
  model.setFree(*u, [&](auto const& x) -> std::array<double, 2> {
    return {gamma * x[1], gamma * x[1]};
  });
  auto const beyond = model.body.cells->largestExcess(*u);
  ASSERT_TRUE(beyond);
  EXPECT_GE(beyond->shear_stress, 350 * (1 - 1e-12));
  EXPECT_GT(beyond->shear_stress, beyond->kept);
}
} // namespace asperity::dynamics
