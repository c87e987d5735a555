#include "dynamics/rate/StepSolvers.hpp"

#include "unit/dynamics/SlidingBlock.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
const DyadicTime clock_of_tests(1e-2, 6);

StepSolvers makeSolvers(Model const& model, std::size_t budget,
                        RateUpdate const& update = RateUpdate::newmark(0.25))
{
  return StepSolvers(model.body, *model.surface, update, clock_of_tests, tightSettings(), budget);
}

std::size_t bytesOfOne(Model const& model)
{
  auto solvers = makeSolvers(model, 1u << 30);
  return solvers.at(0).bytes();
}
} // namespace

TEST(StepSolvers, AreMadeOnceForEachLevel)
{
  const Model model(slidingBlock(2), fem::test::selfCommunicator());
  auto solvers = makeSolvers(model, 1u << 30);
  auto* const first = &solvers.at(3);
  auto* const second = &solvers.at(4);
  EXPECT_NE(first, second);
  EXPECT_EQ(&solvers.at(3), first);
  EXPECT_EQ(&solvers.at(4), second);
  EXPECT_EQ(solvers.setups(), 2);
  EXPECT_EQ(solvers.bytes(), first->bytes() + second->bytes());
}

TEST(StepSolvers, ForgetTheLeastRecentlyUsedBeyondTheBudget)
{
  const Model model(slidingBlock(2), fem::test::selfCommunicator());
  const std::size_t one = bytesOfOne(model);
  auto solvers = makeSolvers(model, 5 * one / 2); // room for two
  for (int level : {0, 1, 0}) {
    solvers.at(level);
  }
  EXPECT_EQ(solvers.setups(), 2);
  solvers.at(2); // in place of 1
  EXPECT_LE(solvers.bytes(), 5 * one / 2);
  solvers.at(0);
  EXPECT_EQ(solvers.setups(), 3);
  solvers.at(1);
  EXPECT_EQ(solvers.setups(), 4);
}

TEST(StepSolvers, KeepTheOneInUseHoweverSmallTheBudget)
{
  const Model model(slidingBlock(2), fem::test::selfCommunicator());
  auto solvers = makeSolvers(model, 1);
  for (int level : {0, 0, 1, 0}) {
    const std::size_t in_use = solvers.at(level).bytes();
    EXPECT_EQ(solvers.bytes(), in_use);
  }
  EXPECT_EQ(solvers.setups(), 3);
}

// Without friction a rate problem is linear: Z w = b, Z = (lambda_M/tau) M + C + (tau/lambda_K) K.
TEST(StepSolvers, SolveWithTheMatrixOfTheStepSize)
{
  auto options = slidingBlock(2);
  options.sigma_n = 0;
  const Model model(options, fem::test::selfCommunicator());
  auto const M = denseOf(*model.body.matrices.mass);
  auto const C = denseOf(*model.body.matrices.viscosity);
  auto const K = denseOf(*model.body.matrices.stiffness);
  auto b = model.body.vector();
  b->randomize();
  model.body.clearHeld(*b);
  auto const guess = model.body.vector();
  auto w = model.body.vector();
  auto const alpha = model.nodeView([](auto const&) { return 0.; });
  const std::tuple<RateUpdate, double, double> weights[] = {
    {RateUpdate::newmark(0.3), 2, 0.6},
    {RateUpdate::backwardEuler(), 1, 1},
    {RateUpdate::generalisedAlpha(0), 4 / 3., 2 / 3.}};
  for (auto const& [update, of_mass, of_stiffness] : weights) {
    auto solvers = makeSolvers(model, 1u << 30, update);
    for (int level : {0, 5}) {
      const double tau = clock_of_tests.stepSize(level);
      Eigen::MatrixXd Z = of_mass / tau * M + C + of_stiffness * tau * K;
      for (int dof = 0; dof < model.body.numOwnedDofs(); ++dof) {
        if (model.body.held[dof]) {
          const double diagonal = Z(dof, dof);
          Z.row(dof).setZero();
          Z.col(dof).setZero();
          Z(dof, dof) = diagonal;
        }
      }
      auto& solver = solvers.at(level);
      solver.begin(*b, *guess);
      EXPECT_TRUE(
        solver.solve(FrictionProblem(model.fault.friction(), {alpha, model.restingState().sigma_n}))
          .converged);
      solver.velocity(*w);
      const Eigen::VectorXd expected = Z.lu().solve(denseOf(*b));
      EXPECT_LE((denseOf(*w) - expected).norm(), 1e-11 * expected.norm());
    }
  }
}
} // namespace asperity::dynamics
