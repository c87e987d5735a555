#include "dynamics/coupling/CoupledStep.hpp"

#include "unit/dynamics/DenseReference.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
RCP<const Communicator> alone() { return fem::test::selfCommunicator(); }

const DyadicTime milliseconds(4e-3, 4);

State solved(Stepper& stepper, State const& from, int level)
{
  auto to = from.clone();
  auto const result = stepper.step.solve(from, level, to, stepper.count);
  EXPECT_TRUE(result.solved());
  return to;
}

void expectNear(DenseState const& state, DenseState const& expected, double tolerance)
{
  auto const distance = [](Eigen::VectorXd const& x, Eigen::VectorXd const& y) {
    return (x - y).lpNorm<Eigen::Infinity>() / y.lpNorm<Eigen::Infinity>();
  };
  EXPECT_LE(distance(state.u, expected.u), tolerance);
  EXPECT_LE(distance(state.v, expected.v), tolerance);
  EXPECT_LE(distance(state.a, expected.a), tolerance);
  EXPECT_LE(distance(state.jerk, expected.jerk), tolerance);
  EXPECT_LE(distance(state.alpha, expected.alpha), tolerance);
}

// f(v, alpha) on all dofs.
Eigen::VectorXd frictionForce(Model const& model, State const& state)
{
  const int size = model.surface->numNodes();
  BlockView v("v", size, 1), gradient("gradient", size, 1);
  HessianView hessian("hessian", size, 1, 1);
  FlagView kinked("kinked", size);
  gather(*model.surface, *state.v, v);
  model.fault.friction().linearise(v, {state.alpha_of_rate, state.sigma_n}, gradient, hessian,
                                   kinked);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(model.body.numOwnedDofs());
  for (int i = 0; i < size; ++i) {
    force[(*model.surface)[i].dofs[0]] = gradient(i, 0);
  }
  return force;
}
} // namespace

using Scheme = DenseReference::Scheme;

struct SchemeCase
{
  RateUpdate update;
  Scheme scheme;
  double parameter;
};

class CoupledStepSchemes : public ::testing::TestWithParam<SchemeCase>
{
protected:
  // The solver and the reference from the same state over steps of several sizes.
  static void compare(ModelOptions const& options, Correction correction)
  {
    auto const& scheme = GetParam();
    const Model model(options, alone());
    Stepper stepper(model, scheme.update, milliseconds, tightCoupling(), tightSettings(correction));
    const DenseReference reference(model, scheme.scheme, scheme.parameter);
    auto state = slidingState(model);
    auto expected = denseOf(state);
    for (int level : {2, 2, 1, 3}) {
      state = solved(stepper, state, level);
      expected =
        reference.step(expected, milliseconds.seconds(state.time), milliseconds.stepSize(level));
      expectNear(denseOf(state), expected, 1e-9);
    }
    EXPECT_EQ(stepper.count.energy_increases, 0);
    EXPECT_EQ(stepper.count.coupled_steps, 4);
  }
};

TEST_P(CoupledStepSchemes, AgreeWithNewtonOnDenseMatrices)
{
  for (int components : {1, 2}) {
    for (auto correction : {Correction::direct, Correction::multigrid}) {
      SCOPED_TRACE(::testing::Message()
                   << components << " components, "
                   << (correction == Correction::direct ? "direct" : "multigrid"));
      compare(slidingBlock(components), correction);
    }
  }
}

TEST_P(CoupledStepSchemes, MeetFrictionUnderTheNormalStressAtTheEndOfTheStep)
{
  auto options = slidingBlock(2);
  options.normal_stress = [](Point<2> const& x, double t) {
    return 2000 * (1 + 0.1 * x[0]) * (1 - 30 * t);
  };
  compare(options, Correction::direct);
}

// The state sees slip, which is twice the displacement of half of an antisymmetric whole.
TEST_P(CoupledStepSchemes, SeeSlipRatherThanDisplacement)
{
  auto options = slidingBlock(1);
  options.other_side = fem::OtherSide::mirror_image;
  compare(options, Correction::direct);
}

// A fault that has slid far and hardly moves: (u1 - u0) / tau is lost in the rounding of u. Sliding
// is steady, so that alpha stays.
TEST_P(CoupledStepSchemes, SeeRatesBelowTheRoundingOfTheDisplacement)
{
  const double rate = 1e-16; // m/s, after 100 m of slip
  auto options = slidingBlock(1);
  options.conditions = {};
  options.reference_rate = rate;
  options.L = 4 * rate * milliseconds.stepSize(2);
  options.traction = options.sigma_n * options.a *
                     std::asinh(0.5 * std::exp(options.reference_friction / options.a));
  const Model model(options, alone());
  Stepper stepper(model, GetParam().update, milliseconds);
  auto state = model.restingState();
  state.u->putScalar(100);
  state.v->putScalar(rate);
  for (int n = 0; n < 4; ++n) {
    state = solved(stepper, state, 2);
    EXPECT_LE(denseOf(state.alpha).lpNorm<Eigen::Infinity>(), 1e-7);
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, CoupledStepSchemes,
  ::testing::Values(SchemeCase{RateUpdate::newmark(0.25), Scheme::newmark, 0.25},
                    SchemeCase{RateUpdate::newmark(0.4), Scheme::newmark, 0.4},
                    SchemeCase{RateUpdate::backwardEuler(), Scheme::backward_euler, 0},
                    SchemeCase{RateUpdate::generalisedAlpha(0), Scheme::generalised_alpha, 0},
                    SchemeCase{RateUpdate::generalisedAlpha(0.5), Scheme::generalised_alpha, 0.5}));

// To the last bit: only then may a control complete what it accepts, and leave out the rest.
TEST(CoupledStep, MayBeCompletedLater)
{
  const Model model(slidingBlock(2), alone());
  const State from = slidingState(model);
  for (auto const& update : {RateUpdate::newmark(0.25), RateUpdate::generalisedAlpha(0.5)}) {
    Stepper stepper(model, update, milliseconds), in_parts(model, update, milliseconds);
    const auto expected = solved(stepper, from, 1);
    auto to = from.clone();
    auto result = in_parts.step.solveAtFault(from, 1, to, in_parts.count);
    ASSERT_TRUE(result.solved());
    EXPECT_EQ(distance(*model.surface, to.alpha, expected.alpha, Norm::maximum), 0);
    EXPECT_EQ(denseOf(*to.u), denseOf(*from.u)) << "only the fault was asked for";
    EXPECT_EQ(denseOf(*to.a), denseOf(*from.a));
    for (int dof : (*model.surface)[2].dofs) {
      EXPECT_EQ(denseOf(*to.v)[dof], denseOf(*expected.v)[dof]);
    }
    in_parts.step.complete(*result.rest, from, to);
    EXPECT_EQ(denseOf(*to.u), denseOf(*expected.u));
    EXPECT_EQ(denseOf(*to.v), denseOf(*expected.v));
    EXPECT_EQ(denseOf(*to.a), denseOf(*expected.a));
    EXPECT_EQ(denseOf(*to.jerk), denseOf(*expected.jerk));
  }
}

// Every step ends at the same fixed point, and sooner.
TEST(CoupledStep, TakesFewerIterationsFromSeveralIterates)
{
  const Model model(slidingBlock(2), alone());
  auto plain = tightCoupling();
  plain.anderson_depth = 0;
  Stepper slow(model, RateUpdate::newmark(0.25), milliseconds, plain);
  Stepper fast(model, RateUpdate::newmark(0.25), milliseconds, tightCoupling());
  auto state = slidingState(model);
  for (int level : {0, 0, 1}) {
    auto expected = state.clone(), accelerated = state.clone();
    auto const of_slow = slow.step.solve(state, level, expected, slow.count);
    auto const of_fast = fast.step.solve(state, level, accelerated, fast.count);
    EXPECT_TRUE(of_slow.solved() && of_fast.solved());
    EXPECT_LT(of_fast.iterations, of_slow.iterations);
    expectNear(denseOf(accelerated), denseOf(expected), 1e-9);
    state = expected.clone();
  }
}

// The largest change is met where a mean would hide it.
TEST(CoupledStep, IteratesUntilTheNormAskedForIsSmall)
{
  const Model model(slidingBlock(2), alone());
  auto from = slidingState(model);
  from.alpha(0) -= 3; // one node out of equilibrium
  auto settings = tightCoupling();
  settings.anderson_depth = 0;
  std::vector<int> iterations;
  // Some lie between a mean and a maximum. They were made this dense after five of them, a decade
  // apart, had told no difference: the two norms are closer than a factor of two here.
  for (int k = 32; k <= 128; ++k) {
    settings.tolerance = std::pow(10, -k / 16.);
    for (Norm norm : {Norm::root_mean_square, Norm::maximum}) {
      settings.norm = norm;
      Stepper stepper(model, RateUpdate::newmark(0.25), milliseconds, settings);
      auto to = from.clone();
      auto const result = stepper.step.solve(from, 0, to, stepper.count);
      EXPECT_TRUE(result.solved());
      iterations.push_back(result.iterations);
    }
  }
  int more = 0;
  for (std::size_t i = 0; i < iterations.size(); i += 2) {
    EXPECT_GE(iterations[i + 1], iterations[i]);
    more += iterations[i + 1] - iterations[i];
  }
  EXPECT_GT(more, 0);
}

// Friction is off by alpha - alpha_of_rate in each step. These errors add up to the last defect
// alone, however many steps there are: exactly, up to rounding.
TEST(CoupledStep, TakesBackWhatTheFixedPointOfTheStepBeforeHasLeft)
{
  const Model model(slidingBlock(2), alone());
  auto settings = tightCoupling();
  settings.tolerance = 1e-3;
  Stepper stepper(model, RateUpdate::generalisedAlpha(0.5), milliseconds, settings);
  auto state = slidingState(model);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(model.surface->numNodes());
  double largest_error = 0;
  for (int step = 0; step < 30; ++step) {
    state = solved(stepper, state, 3);
    const Eigen::VectorXd error = denseOf(state.alpha) - denseOf(state.alpha_of_rate);
    sum += error;
    largest_error = std::max(largest_error, error.lpNorm<Eigen::Infinity>());
    EXPECT_LE((sum - denseOf(state.alpha_defect)).lpNorm<Eigen::Infinity>(), 1e-13);
  }
  EXPECT_GT(largest_error, 1e-6) << "nothing was left";
}

TEST(CoupledStep, EndsInBalanceOfMomentumUnderEveryLaw)
{
  for (std::string const law : {"Regularised", "Truncated"}) {
    for (std::string const state_law : {"Ageing", "Slip"}) {
      auto options = slidingBlock(2);
      fem::test::rotate(options.mesh, -0.2);
      options.law = law;
      options.state_law = state_law;
      options.other_side = fem::OtherSide::mirror_image;
      options.cohesion = 20;
      const Model model(options, alone());
      Stepper stepper(model, RateUpdate::newmark(0.25), milliseconds);
      auto state = solved(stepper, slidingState(model), 2);
      state = solved(stepper, state, 3);

      auto load = model.body.vector();
      auto rest = model.body.vector();
      model.body.load(0, *load);
      model.body.residual(*load, state.motion(), *rest);
      Eigen::VectorXd imbalance = denseOf(*rest) - frictionForce(model, state);
      for (int dof = 0; dof < model.body.numOwnedDofs(); ++dof) {
        imbalance[dof] = model.body.held[dof] ? 0 : imbalance[dof];
      }
      const double scale = denseOf(*rest).lpNorm<Eigen::Infinity>();
      EXPECT_LE(imbalance.lpNorm<Eigen::Infinity>(), 1e-10 * scale) << law << ", " << state_law;
    }
  }
}

TEST(CoupledStep, MoveFixedDofsAsPrescribedAtTheEndOfTheStep)
{
  const Model model(slidingBlock(2), alone());
  Stepper stepper(model, RateUpdate::newmark(0.25), milliseconds);
  auto const state = solved(stepper, slidingState(model), 0);
  auto const v = denseOf(*state.v);
  EXPECT_EQ(state.time, milliseconds.ticks(0));
  for (int node = 0; node < model.mesh.num_owned; ++node) {
    auto const& x = model.mesh.vertices[node];
    if (x[0] == 0.4) {
      EXPECT_DOUBLE_EQ(v[model.body.dofs->dof(node, 0)], loading_rate * (1 + x[1] + 30 * 4e-3));
    }
    if (x[1] == 0) {
      EXPECT_EQ(v[model.body.dofs->dof(node, 1)], 0);
    }
  }
}

TEST(CoupledStep, LeavesAFaultAtRestThatCohesionHolds)
{
  auto options = slidingBlock(2);
  options.conditions = {};
  options.cohesion = 1e4;
  const Model model(options, alone());
  Stepper stepper(model, RateUpdate::newmark(0.25), milliseconds);
  auto const state = solved(stepper, model.restingState(), 1);
  auto const v = denseOf(*state.v);
  EXPECT_GT(v.norm(), 0);
  for (auto const& node : *model.surface) {
    EXPECT_EQ(v[node.dofs[0]], 0);
  }
  // theta = theta0 + t
  const double healed = std::log1p(options.reference_rate / options.L * milliseconds.stepSize(1));
  for (double alpha : denseOf(state.alpha)) {
    EXPECT_NEAR(alpha, healed, 1e-15);
  }
}

TEST(CoupledStep, SaysWhyItFailed)
{
  const Model model(slidingBlock(2), alone());
  auto const from = slidingState(model);
  auto to = from.clone();

  auto hasty = tightCoupling();
  hasty.max_iterations = 1;
  Stepper coupling(model, RateUpdate::newmark(0.25), milliseconds, hasty);
  auto result = coupling.step.solve(from, 0, to, coupling.count);
  EXPECT_EQ(result.status, StepStatus::fixed_point_failed);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_EQ(coupling.count.failures, 1);

  auto adrift = from.clone();
  adrift.u->putScalar(std::nan(""));
  Stepper rate(model, RateUpdate::newmark(0.25), milliseconds);
  to = from.clone();
  result = rate.step.solve(adrift, 0, to, rate.count);
  EXPECT_EQ(result.status, StepStatus::rate_problem_failed);
  EXPECT_FALSE(result.solved());

  auto broken = from.clone();
  broken.alpha(1) = std::nan("");
  Stepper state(model, RateUpdate::newmark(0.25), milliseconds);
  to = from.clone();
  result = state.step.solve(broken, 0, to, state.count);
  EXPECT_EQ(result.status, StepStatus::state_failed);
  EXPECT_EQ(state.count.failures, 1);
}

TEST(SolveCount, ListsAllItsMembersOnce)
{
  SolveCount count;
  std::int64_t n = 0;
  std::set<std::string> names;
  for (auto const& member : SolveCount::members()) {
    EXPECT_EQ(count.*member.value, 0) << member.name;
    count.*member.value = ++n;
    names.insert(member.name);
  }
  EXPECT_EQ(sizeof(SolveCount), n * sizeof(std::int64_t));
  EXPECT_EQ(names.size(), SolveCount::members().size());
}

TEST(SolveCount, SinceIsTheDifferenceOfEveryMember)
{
  SolveCount before, after;
  std::int64_t n = 0;
  for (auto const& member : SolveCount::members()) {
    before.*member.value = ++n;
    after.*member.value = 10 * n;
  }
  n = 0;
  auto const difference = after.since(before);
  for (auto const& member : SolveCount::members()) {
    EXPECT_EQ(difference.*member.value, 9 * ++n) << member.name;
  }
}
} // namespace asperity::dynamics
