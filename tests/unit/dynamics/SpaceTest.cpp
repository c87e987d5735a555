#include "dynamics/control/PrescribedSteps.hpp"
#include "dynamics/initial/InitialAcceleration.hpp"
#include "dynamics/observables/EnergyBalance.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

// Friction as a vector law: on a bent fault in space, whichever way that lies.
namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
const Rotation upright = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

// A block, the steps it has made, and its balance of energy.
struct SpaceRun
{
  SpaceRun(Rotation const& turn, RateSolverSettings const& settings = tightSettings())
      : model(slidingBlockInSpace({5, 3, 4}, turn), fem::test::selfCommunicator())
      , stepper(model, RateUpdate::newmark(0.25), DyadicTime(4e-3, 4), tightCoupling(), settings)
      , energy(model.body, model.fault, stepper.clock)
      , state(slidingState(model, turn))
  {
    auto load = model.body.vector();
    model.body.load(0, *load);
    state.a = initialAcceleration(model.body, model.fault, settings, *load,
                                  {*state.u, *state.v, *model.body.vector(), {}},
                                  {state.alpha, state.sigma_n});
    energy.start(state);
    PrescribedSteps steps({stepper.step}, {0, 1, 2});
    for (int n = 0; n < 4; ++n) {
      steps.advance(state, stepper.count);
      energy.advance(state);
    }
  }

  ModelIn<3> model;
  Stepper stepper;
  EnergyBalance energy;
  State state;
};

double largest(Point<3> const& x)
{
  return std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
}

// Largest difference of a vector of a turned run from that of an upright one, relative to the
// latter.
double differenceOf(RCP<Vector> State::*vector, SpaceRun const& turned, SpaceRun const& run,
                    Rotation const& turn)
{
  double difference = 0;
  double scale = 0;
  for (int node = 0; node < run.model.mesh.num_owned; ++node) {
    auto const expected = rotated(turn, run.model.valueAt(*(run.state.*vector), node));
    auto const value = turned.model.valueAt(*(turned.state.*vector), node);
    difference =
      std::max(difference,
               largest({value[0] - expected[0], value[1] - expected[1], value[2] - expected[2]}));
    scale = std::max(scale, largest(expected));
  }
  return difference / scale;
}
} // namespace

TEST(Space, SlipsInBothDirectionsBesideAWall)
{
  const SpaceRun run(upright);
  auto const& fault = *run.model.surface;
  auto const values = run.state.v->getLocalViewHost(Tpetra::Access::ReadOnly);
  int num_sliding = 0;
  int num_partly_fixed = 0;
  for (int node = 0; node < fault.numNodes(); ++node) {
    double least = 1;
    for (int k = 0; k < 2 && fault.slides(node); ++k) {
      if (fault.held(node, k)) {
        ++num_partly_fixed;
        EXPECT_EQ(values(fault[node].dofs[k], 0), 0) << "the wall";
      } else {
        least = std::min(least, std::abs(values(fault[node].dofs[k], 0)));
      }
    }
    num_sliding += least > 0.1 * loading_rate ? 1 : 0;
  }
  EXPECT_EQ(num_partly_fixed, 5);
  EXPECT_GT(num_sliding, fault.numNodes() / 2) << "in both directions";
  EXPECT_EQ(run.stepper.count.energy_increases, 0);
  EXPECT_EQ(run.stepper.count.failures, 0);
  EXPECT_EQ(run.stepper.count.coupled_steps, 4);
  auto const& energy = run.energy.energy();
  EXPECT_LE(std::abs(energy.defect), 1e-9 * std::abs(energy.friction_work));
  EXPECT_GT(energy.friction_work, 0);
}

TEST(Space, GivesTheTurnedAnswerToATurnedProblem)
{
  const SpaceRun run(upright);
  const Rotation turns[] = {fem::test::rotationAbout({1, 2, 3}, 0.8),
                            fem::test::rotationAbout({-2, 1, 0.5}, 2.6),
                            fem::test::rotationAbout({0, 0, 1}, M_PI / 2)};
  for (auto const& turn : turns) {
    const SpaceRun turned(turn);
    EXPECT_LE(differenceOf(&State::v, turned, run, turn), 1e-8);
    EXPECT_LE(differenceOf(&State::u, turned, run, turn), 1e-8);
    EXPECT_LE(differenceOf(&State::a, turned, run, turn), 1e-8);
    for (int node = 0; node < run.model.surface->numNodes(); ++node) {
      EXPECT_NEAR(turned.state.alpha(node), run.state.alpha(node), 1e-8);
    }
    EXPECT_NEAR(turned.energy.energy().friction_work / run.energy.energy().friction_work, 1, 1e-8);
  }
}

// Pushed in one direction along the fault, the nodes at the drive slip in the other one as friction
// lets them. Momentum balances there, too, so that the energy does.
TEST(Space, SlipsAcrossTheDirectionOfADrive)
{
  auto options = slidingBlockInSpace({5, 3, 4}, upright);
  options.conditions.erase(options.conditions.begin() + 1);
  const ModelIn<3> model(options, fem::test::selfCommunicator());
  auto const energy = energyOfSteps(model, slidingState(model, upright));
  EXPECT_GT(energy.friction_work, 0);
  EXPECT_LE(std::abs(energy.defect), 1e-9 * energy.friction_work);
  Stepper stepper(model, RateUpdate::newmark(0.25), DyadicTime(4e-3, 4));
  auto const from = slidingState(model, upright);
  auto to = from.clone();
  EXPECT_TRUE(stepper.step.solve(from, 0, to, stepper.count).solved());
  auto const values = to.v->getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const& fault = *model.surface;
  int num_driven = 0;
  for (int node = 0; node < fault.numNodes(); ++node) {
    for (int k = 0; k < 2; ++k) {
      const double held = values(fault[node].dofs[k], 0);
      if (fault.held(node, k) && std::abs(held) > 0) {
        ++num_driven;
        EXPECT_FALSE(fault.held(node, 1 - k));
        EXPECT_GT(std::abs(values(fault[node].dofs[1 - k], 0)), 0.01 * loading_rate);
      }
    }
  }
  EXPECT_EQ(num_driven, 5);
}
} // namespace asperity::dynamics
