#include "dynamics/observables/EnergyBalance.hpp"

#include "dynamics/initial/InitialAcceleration.hpp"
#include "dynamics/initial/StaticSolver.hpp"
#include "unit/dynamics/QuasiDynamicModel.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
const DyadicTime milliseconds(4e-3, 4);

// With an acceleration that balances momentum.
State balanced(dynamics::test::Model const& model, State state)
{
  auto load = model.body.vector();
  auto prescribed = model.body.vector();
  auto later = model.body.vector();
  model.body.load(0, *load);
  model.body.prescribed_velocity(1, *later);
  model.body.prescribed_velocity(0, *prescribed);
  prescribed->update(1, *later, -1);
  state.a = initialAcceleration(model.body, model.fault, tightSettings(), *load,
                                {*state.u, *state.v, *prescribed, state.branches},
                                {state.alpha, state.sigma_n});
  return state;
}

State balancedState(dynamics::test::Model const& model)
{
  return balanced(model, slidingState(model));
}

void advance(Stepper& stepper, State& state, int level)
{
  auto next = state.clone();
  ASSERT_TRUE(stepper.step.solve(state, level, next, stepper.count).solved());
  state = next;
}
} // namespace

TEST(EnergyBalance, ClosesWithTheTrapezoidalRuleWhateverTheSteps)
{
  for (int components : {1, 2}) {
    auto options = slidingBlock(components);
    options.cohesion = 15;
    const dynamics::test::Model model(options, fem::test::selfCommunicator());
    Stepper stepper(model, RateUpdate::newmark(0.25), milliseconds);
    EnergyBalance balance(model.body, model.fault, milliseconds);
    auto state = balancedState(model);
    auto const u0 = denseOf(*state.u);
    balance.start(state);
    for (int level : {2, 2, 1, 4, 0, 0, 1, 2, 3, 0, 0, 0}) {
      const double before = balance.energy().defect;
      advance(stepper, state, level);
      auto const& energy = balance.advance(state);
      EXPECT_NEAR(energy.defect, before, 1e-10 * energy.friction_work);
    }
    auto const& energy = balance.energy();
    EXPECT_NEAR(energy.numerical_dissipation, 0, 1e-10 * energy.friction_work);
    auto load = model.body.vector();
    model.body.load(0, *load);
    EXPECT_NEAR(energy.load_work, denseOf(*load).dot(denseOf(*state.u) - u0),
                1e-12 * std::abs(energy.load_work));
    auto const u = denseOf(*state.u);
    auto const v = denseOf(*state.v);
    EXPECT_NEAR(energy.kinetic, 0.5 * v.dot(denseOf(*model.body.matrices.mass) * v),
                1e-13 * energy.kinetic);
    EXPECT_NEAR(energy.elastic, 0.5 * u.dot(denseOf(*model.body.matrices.stiffness) * u),
                1e-12 * energy.elastic);
    EXPECT_GT(energy.friction_work, 0);
    EXPECT_GT(energy.viscous_work, 0);
    EXPECT_NE(energy.boundary_work, 0);
  }
}

// However loose the coupling: what counts is the state that the velocity was computed with.
TEST(EnergyBalance, ClosesWhereAlphaIsStillMoving)
{
  const dynamics::test::Model model(slidingBlock(2), fem::test::selfCommunicator());
  auto loose = tightCoupling();
  loose.tolerance = 0.1;
  Stepper stepper(model, RateUpdate::newmark(0.25), milliseconds, loose);
  EnergyBalance balance(model.body, model.fault, milliseconds);
  auto state = balancedState(model);
  balance.start(state);
  for (int n = 0; n < 8; ++n) {
    advance(stepper, state, 1);
    balance.advance(state);
  }
  EXPECT_GT(distance(*model.surface, state.alpha, state.alpha_of_rate), 1e-6);
  EXPECT_NEAR(balance.energy().defect / balance.energy().friction_work, 0, 1e-10);
}

TEST(EnergyBalance, SplitsTheWorkOfFrictionAndOfThePushedBoundary)
{
  // Steady: a rigid block in uniform motion, friction bears the traction and the push together.
  auto options = slidingBlock(2);
  options.gravity = {0, 0};
  options.traction = 1000;
  auto const pushed = [](auto const&, double) { return 1e-3; };
  options.conditions = {{"Push", "right", fem::PrescribedVelocity<2>{{1, 0}, pushed}}};
  options.b = 0;
  const dynamics::test::Model model(options, fem::test::selfCommunicator());
  auto state = model.restingState();
  model.setFree(*state.v, [](auto const&) -> std::array<double, 2> { return {1e-3, 0}; });
  // K u = traction - friction, at the fixed dofs the push.
  Vector force(*model.body.vector());
  const double mu = options.a * std::asinh(1e-3 / (2 * options.reference_rate) *
                                           std::exp(options.reference_friction / options.a));
  const double rest = options.traction - options.sigma_n * mu; // Pa on the base
  for (int i = 0; i < model.surface->numNodes(); ++i) {
    force.replaceLocalValue((*model.surface)[i].dofs[0], rest * (*model.surface)[i].weight);
  }
  state.u = StaticSolver(model.body, tightSettings()).solve(force);
  Stepper stepper(model, RateUpdate::newmark(0.25), milliseconds);
  EnergyBalance balance(model.body, model.fault, milliseconds);
  balance.start(state);
  for (int n = 0; n < 4; ++n) {
    advance(stepper, state, 1);
    balance.advance(state);
  }
  const double slip = 1e-3 * milliseconds.seconds(state.time);
  // Where the base itself is pushed, what friction takes is part of what the push has to give.
  const double base = 0.4, free_base = 0.35; // m
  auto const& energy = balance.energy();
  EXPECT_NEAR(energy.friction_work / (options.sigma_n * mu * free_base * slip), 1, 1e-9);
  EXPECT_NEAR(energy.load_work / (options.traction * base * slip), 1, 1e-9);
  const double push = options.sigma_n * mu * free_base - options.traction * base; // N/m
  EXPECT_NEAR(energy.boundary_work / (push * slip), 1, 1e-8);
}

// rho v' = -K u alone: what backward Euler loses is 1/2 (du'K du + dv'M dv) in each step.
TEST(EnergyBalance, NamesWhatBackwardEulerDissipates)
{
  auto options = slidingBlock(1);
  options.sigma_n = options.traction = 0;
  options.conditions = {};
  options.material.shear_viscosity = 0;
  const dynamics::test::Model model(options, fem::test::selfCommunicator());
  auto const M = denseOf(*model.body.matrices.mass);
  auto const K = denseOf(*model.body.matrices.stiffness);
  Stepper stepper(model, RateUpdate::backwardEuler(), milliseconds);
  EnergyBalance balance(model.body, model.fault, milliseconds);
  auto state = slidingState(model);
  balance.start(state);
  for (int n = 0; n < 5; ++n) {
    auto const before = state.clone();
    const double dissipated = balance.energy().numerical_dissipation;
    advance(stepper, state, 0);
    balance.advance(state);
    const Eigen::VectorXd du = denseOf(*state.u) - denseOf(*before.u);
    const Eigen::VectorXd dv = denseOf(*state.v) - denseOf(*before.v);
    const double lost = (du.dot(K * du) + dv.dot(M * dv)) / 2;
    EXPECT_NEAR((balance.energy().numerical_dissipation - dissipated) / lost, 1, 1e-9);
  }
  EXPECT_NEAR(balance.energy().defect / balance.energy().numerical_dissipation, 0, 1e-9);
}

class EnergyOfSchemes : public ::testing::TestWithParam<RateUpdate>
{
};

// With friction, viscosity, moving boundaries and steps of all sizes.
TEST_P(EnergyOfSchemes, ClosesOnceTheirDissipationIsCounted)
{
  for (int components : {1, 2}) {
    auto options = slidingBlock(components);
    options.cohesion = 15;
    const dynamics::test::Model model(options, fem::test::selfCommunicator());
    Stepper stepper(model, GetParam(), milliseconds);
    EnergyBalance balance(model.body, model.fault, milliseconds);
    auto state = balancedState(model);
    balance.start(state);
    for (int level : {2, 2, 1, 4, 0, 0, 1, 2, 3, 0, 0, 0}) {
      const double before = balance.energy().defect;
      advance(stepper, state, level);
      auto const& energy = balance.advance(state);
      EXPECT_NEAR(energy.defect, before, 1e-10 * energy.kinetic);
    }
    // Far more than the defect; of either sign as long as the body gains speed.
    EXPECT_GT(std::abs(balance.energy().numerical_dissipation), 1e-4 * balance.energy().kinetic);
  }
}

TEST_P(EnergyOfSchemes, IsDissipatedWhereTheBodyIsLeftAlone)
{
  auto options = slidingBlock(2);
  options.sigma_n = options.traction = 0;
  options.gravity = {0, 0};
  options.conditions = {};
  options.material.shear_viscosity = options.material.bulk_viscosity = 0;
  const dynamics::test::Model model(options, fem::test::selfCommunicator());
  Stepper stepper(model, GetParam(), milliseconds);
  EnergyBalance balance(model.body, model.fault, milliseconds);
  auto state = model.restingState();
  model.setFree(*state.v, [](Point<2> const& x) -> std::array<double, 2> {
    return {std::sin(20 * x[0]), std::cos(9 * x[0] * x[1])};
  });
  state = balanced(model, state);
  balance.start(state);
  const double first = balance.energy().kinetic;
  for (int level : {2, 2, 1, 4, 0, 0, 1, 2, 3, 0, 0, 0}) {
    advance(stepper, state, level);
    balance.advance(state);
  }
  auto const& energy = balance.energy();
  EXPECT_GT(energy.numerical_dissipation, 0.02 * first);
  EXPECT_NEAR(energy.kinetic + energy.elastic + energy.numerical_dissipation, first, 1e-10 * first);
}

INSTANTIATE_TEST_SUITE_P(All, EnergyOfSchemes,
                         ::testing::Values(RateUpdate::backwardEuler(),
                                           RateUpdate::generalisedAlpha(0),
                                           RateUpdate::generalisedAlpha(0.5)));

// Friction is measured under the normal stress of the state, even where steps beyond it have been
// tried in between, and that normal stress is what remains for others to read.
TEST(EnergyBalance, FollowsAChangingNormalStress)
{
  auto options = slidingBlock(2);
  options.normal_stress = [](Point<2> const& x, double t) {
    return 2000 * (1 + 0.1 * x[0]) * (1 - 30 * t);
  };
  const dynamics::test::Model model(options, fem::test::selfCommunicator());
  Stepper stepper(model, RateUpdate::newmark(0.25), milliseconds);
  EnergyBalance balance(model.body, model.fault, milliseconds);
  auto state = balancedState(model);
  balance.start(state);
  for (int level : {2, 1, 3, 2}) {
    advance(stepper, state, level);
    auto trial = state.clone();
    advance(stepper, trial, 0);
    balance.advance(state);
    for (int i = 0; i < model.surface->numNodes(); ++i) {
      EXPECT_EQ(state.sigma_n(i),
                model.normalStress(model.surface->vertex(i), milliseconds.seconds(state.time)));
    }
  }
  EXPECT_NEAR(balance.energy().defect / balance.energy().friction_work, 0, 1e-10);
}

TEST(EnergyBalance, GoesOnFromTheWorksOfAnEarlierRun)
{
  const dynamics::test::Model model(slidingBlock(2), fem::test::selfCommunicator());
  Stepper stepper(model, RateUpdate::newmark(0.25), milliseconds);
  EnergyBalance whole(model.body, model.fault, milliseconds);
  EnergyBalance second(model.body, model.fault, milliseconds);
  auto state = balancedState(model);
  whole.start(state);
  for (int n = 0; n < 4; ++n) {
    advance(stepper, state, 1);
    whole.advance(state);
    if (n == 1) {
      second.resume(state, whole.energy());
    } else if (n > 1) {
      second.advance(state);
    }
  }
  for (auto const& member : Energy::members()) {
    EXPECT_EQ(second.energy().*member.value, whole.energy().*member.value) << member.name;
  }
}

TEST(EnergyBalance, SeesNoWorkWhereTheFaultIsHeld)
{
  auto options = slidingBlock(2);
  options.conditions = {};
  options.cohesion = 1e4;
  const dynamics::test::Model model(options, fem::test::selfCommunicator());
  Stepper stepper(model, RateUpdate::newmark(0.25), milliseconds);
  EnergyBalance balance(model.body, model.fault, milliseconds);
  auto state = model.restingState();
  auto load = model.body.vector();
  model.body.load(0, *load);
  state.a = initialAcceleration(model.body, model.fault, tightSettings(), *load,
                                {*state.u, *state.v, *model.body.vector(), {}},
                                {state.alpha, state.sigma_n});
  balance.start(state);
  for (int n = 0; n < 3; ++n) {
    advance(stepper, state, 1);
    balance.advance(state);
  }
  EXPECT_EQ(balance.energy().friction_work, 0);
  EXPECT_GT(balance.energy().elastic, 0);
  EXPECT_NEAR(balance.energy().defect, 0, 1e-12 * balance.energy().load_work);
  // The fault bears what rests on it: together with the motion that makes the whole load.
  double held = 0, driven = 0;
  auto const force = denseOf(balance.force());
  const Eigen::VectorXd momentum = denseOf(*model.body.matrices.mass) * denseOf(*state.a);
  for (auto const& node : *model.surface) {
    held += force[node.dofs[0]];
  }
  for (int node = 0; node < model.mesh.num_owned; ++node) {
    driven += denseOf(*load)[2 * node] - momentum[2 * node];
  }
  EXPECT_NEAR(held / driven, 1, 1e-10);
}

TEST(Energy, ListsAllItsMembersOnce)
{
  Energy energy;
  double n = 0;
  std::set<std::string> names;
  for (auto const& member : Energy::members()) {
    EXPECT_EQ(energy.*member.value, 0) << member.name;
    energy.*member.value = ++n;
    names.insert(member.name);
  }
  EXPECT_EQ(sizeof(Energy), n * sizeof(double));
  EXPECT_EQ(names.size(), Energy::members().size());
}

namespace
{
// A block whose top rests, without viscosity.
ModelOptions hangingBlock()
{
  auto options = slidingBlock(2);
  options.gravity = {0, 0};
  options.traction = 0;
  options.material.shear_viscosity = options.material.bulk_viscosity = 0;
  options.conditions = {{"Top", "top", fem::AtRestAlong{{1, 0}}},
                        {"Lid", "top", fem::AtRestAlong{{0, 1}}}};
  return options;
}

void advance(dynamics::Model const& model, EnergyBalance& balance, State& state, int num_steps)
{
  CoupledStep step(
    model.body, model.fault,
    {RateUpdate::generalisedAlpha(0.5), milliseconds, tightCoupling(), tightSettings(), 1u << 30});
  SolveCount count;
  for (int n = 0; n < num_steps; ++n) {
    auto next = state.clone();
    ASSERT_TRUE(step.solve(state, 0, next, count).solved());
    state = next;
    balance.advance(state);
  }
}
} // namespace

// A massless body under a load that comes at once: the load does the work l u, of which half
// becomes elastic energy and the other half is given off.
TEST(EnergyBalance, CountsWhatAMasslessBodyGivesOffWhenItFallsIntoPlace)
{
  auto options = hangingBlock();
  options.gravity = {0, -9.81};
  options.sigma_n = 1e9; // the fault is locked
  const dynamics::test::Model block(options, fem::test::selfCommunicator());
  auto const model = quasiDynamic(block);
  EnergyBalance balance(model.body, model.fault, milliseconds);
  auto state = model.initial.clone();
  balance.start(state);
  EXPECT_NEAR(balance.startImbalance(), 1, 0.2); // but for the weight that held nodes bear
  advance(model, balance, state, 3);
  auto const& energy = balance.energy();
  EXPECT_GT(energy.elastic, 0);
  EXPECT_NEAR(energy.numerical_dissipation / energy.elastic, 1, 1e-6);
  EXPECT_NEAR(energy.load_work / energy.elastic, 2, 1e-6);
  EXPECT_NEAR(energy.defect / energy.elastic, 0, 1e-9);
}

// The state slides at a rate that no traction drives: friction at that rate acts on no motion.
TEST(EnergyBalance, StartsWithTheForcesAfterTheJumpOfAQuasiDynamicBody)
{
  const dynamics::test::Model block(hangingBlock(), fem::test::selfCommunicator());
  auto const model = quasiDynamic(block);
  EnergyBalance balance(model.body, model.fault, milliseconds);
  auto state = model.initial.clone();
  block.setFree(*state.v, [](auto const&) -> std::array<double, 2> { return {1e-3, 0}; });
  auto const u0 = denseOf(*state.u);
  balance.start(state);
  EXPECT_NEAR(balance.startImbalance(), 1, 1e-9);
  auto const force = denseOf(balance.force());
  advance(model, balance, state, 2);
  const double naive = 0.5 * std::abs(force.dot(denseOf(*state.u) - u0));
  auto const& energy = balance.energy();
  EXPECT_NEAR(energy.defect, 0, 1e-9 * std::max(naive, 1e-9));
  EXPECT_LT(energy.friction_work, 0.01 * std::max(naive, 1e-9));

  // What a step has led to is in balance.
  balance.resume(state, energy);
  EXPECT_EQ(balance.startImbalance(), 0);
}
} // namespace asperity::dynamics
