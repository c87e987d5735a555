#include "dynamics/control/PrescribedSteps.hpp"
#include "dynamics/initial/InitialAcceleration.hpp"
#include "dynamics/initial/StaticSolver.hpp"
#include "dynamics/observables/EnergyBalance.hpp"
#include "unit/dynamics/FaultNodesOfTests.hpp"
#include "unit/dynamics/SlidingBlock.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
RCP<const Communicator> world() { return fem::test::worldCommunicator(); }

ModelOptions largerBlock()
{
  auto options = slidingBlock(2);
  options.mesh = fem::test::uniformRectangle(32, 24, 0.4, 0.3);
  fem::test::distort(options.mesh, 0.002);
  options.cohesion = 20;
  return options;
}

// The same problem alone and together; nodal frames are the same in both.
template <int Dim>
struct BothWays
{
  explicit BothWays(OptionsIn<Dim> const& options)
      : alone(options, fem::test::selfCommunicator())
      , together(options, world())
  {
  }

  // Largest difference of a vector from the one computed alone, relative to the latter.
  double difference(Vector const& shared, Vector const& own) const
  {
    auto const expected = denseOf(own);
    auto const values = denseOf(shared);
    double largest = 0;
    for (int dof = 0; dof < values.size(); ++dof) {
      const auto id = shared.getMap()->getGlobalElement(dof);
      largest = std::max(largest, std::abs(values[dof] - expected[static_cast<int>(id)]));
    }
    return largest / expected.lpNorm<Eigen::Infinity>();
  }

  double differenceOfAlpha(State const& shared, State const& own) const
  {
    double largest = 0;
    for (int i = 0; i < together.surface->numNodes(); ++i) {
      auto const id = together.mesh.global_ids[together.surface->vertex(i)];
      auto const nodes = alone.surface->vertices();
      const auto place = std::lower_bound(nodes.begin(), nodes.end(), id) - nodes.begin();
      largest = std::max(largest, std::abs(shared.alpha(i) - own.alpha(place)));
    }
    return largest;
  }

  ModelIn<Dim> alone, together;
};

constexpr Rotation upright = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

RateSolverSettings onSeveralLevels()
{
  auto settings = tightSettings(Correction::multigrid);
  settings.multigrid.sublist("MueLu").set("coarse: max size", 100);
  settings.tnnmg.absolute_tolerance = 1e-11;
  settings.tnnmg.relative_tolerance = 1e-11;
  return settings;
}
} // namespace

namespace
{
void expectStepsOfOneRank(ModelOptions const& options)
{
  const BothWays<2> models(options);
  const DyadicTime clock(4e-3, 4);
  auto const update = RateUpdate::newmark(0.25);
  auto coupling = tightCoupling();
  coupling.tolerance = 1e-11;
  Stepper alone(models.alone, update, clock, coupling);
  Stepper together(models.together, update, clock, coupling, onSeveralLevels());
  EnergyBalance energy_alone(models.alone.body, models.alone.fault, clock);
  EnergyBalance energy_together(models.together.body, models.together.fault, clock);
  auto own = slidingState(models.alone);
  auto shared = slidingState(models.together);
  energy_alone.start(own);
  energy_together.start(shared);
  PrescribedSteps steps_alone({alone.step}, {0, 1, 2});
  PrescribedSteps steps_together({together.step}, {0, 1, 2});
  for (int n = 0; n < 4; ++n) {
    steps_alone.advance(own, alone.count);
    steps_together.advance(shared, together.count);
    energy_alone.advance(own);
    energy_together.advance(shared);
    EXPECT_LE(models.difference(*shared.v, *own.v), 1e-7);
    EXPECT_LE(models.difference(*shared.u, *own.u), 1e-7);
    EXPECT_LE(models.difference(*shared.a, *own.a), 1e-7);
    EXPECT_LE(models.differenceOfAlpha(shared, own), 1e-7);
  }
  EXPECT_EQ(together.count.energy_increases, 0);
  EXPECT_NEAR(energy_together.energy().friction_work / energy_alone.energy().friction_work, 1,
              1e-8);
  EXPECT_NEAR(dynamics::test::peakSlipRateAt(*models.together.surface, *shared.v) /
                dynamics::test::peakSlipRateAt(*models.alone.surface, *own.v),
              1, 1e-8);
}
} // namespace

TEST(Ranks, MultigridOnAllStepsLikeCholeskyOnOne) { expectStepsOfOneRank(largerBlock()); }

TEST(Ranks, MultigridOnAllStepsLikeCholeskyOnOneWhereStressRelaxes)
{
  auto options = largerBlock();
  options.relaxation = {{0.5, 1e-3}, {0.4, 0.1}};
  expectStepsOfOneRank(options);
}

// Friction as a vector law; also the effort is that of one rank.
TEST(Ranks, SlideInSpaceLikeOne)
{
  const BothWays<3> models(slidingBlockInSpace({8, 5, 6}, upright));
  const DyadicTime clock(4e-3, 4);
  auto const update = RateUpdate::newmark(0.25);
  auto coupling = tightCoupling();
  coupling.tolerance = 1e-11;
  Stepper direct(models.alone, update, clock, coupling);
  Stepper alone(models.alone, update, clock, coupling, onSeveralLevels());
  Stepper together(models.together, update, clock, coupling, onSeveralLevels());
  auto exact = slidingState(models.alone, upright);
  auto own = exact.clone();
  auto shared = slidingState(models.together, upright);
  PrescribedSteps steps_direct({direct.step}, {0, 1, 2});
  PrescribedSteps steps_alone({alone.step}, {0, 1, 2});
  PrescribedSteps steps_together({together.step}, {0, 1, 2});
  for (int n = 0; n < 3; ++n) {
    const auto before_alone = alone.count, before = together.count;
    steps_direct.advance(exact, direct.count);
    steps_alone.advance(own, alone.count);
    steps_together.advance(shared, together.count);
    EXPECT_LE(models.difference(*shared.v, *exact.v), 1e-8);
    EXPECT_LE(models.difference(*shared.u, *exact.u), 1e-8);
    EXPECT_LE(models.differenceOfAlpha(shared, exact), 1e-8);
    const auto effort = together.count.since(before),
               effort_alone = alone.count.since(before_alone);
    EXPECT_LE(std::abs(effort.rate_problems - effort_alone.rate_problems), 1);
    EXPECT_LE(std::abs(effort.tnnmg_iterations - effort_alone.tnnmg_iterations), 2);
  }
  EXPECT_EQ(together.count.energy_increases, 0);
}

// The ranks' shares of the mesh differ; what they forget must not, since a set-up takes them all.
TEST(Ranks, ForgetTheSameStepSolvers)
{
  const Model model(largerBlock(), world());
  const auto makeSolvers = [&](std::size_t budget) {
    return StepSolvers(model.body, *model.surface, RateUpdate::newmark(0.25), DyadicTime(4e-3, 4),
                       onSeveralLevels(), budget);
  };
  auto roomy = makeSolvers(1u << 30);
  const auto mine = static_cast<double>(roomy.at(0).bytes());
  double least = 0, most = 0;
  Teuchos::reduceAll(*world(), Teuchos::REDUCE_MIN, mine, Teuchos::outArg(least));
  Teuchos::reduceAll(*world(), Teuchos::REDUCE_MAX, mine, Teuchos::outArg(most));
  const bool differ = most > least;
  EXPECT_EQ(differ, world()->getSize() > 1) << "or there is nothing to tell apart";
  EXPECT_EQ(static_cast<double>(roomy.bytes()), most);

  auto narrow = makeSolvers(static_cast<std::size_t>(least + most)); // two, on some ranks alone
  narrow.at(0);
  narrow.at(1);
  const double two = world()->getSize() > 1 ? most : 2 * most;
  EXPECT_EQ(static_cast<double>(narrow.bytes()), two);
}

TEST(Ranks, FindTheSameInitialState)
{
  const BothWays<2> models(largerBlock());
  auto const displacement = [](Model const& model, Correction correction) {
    auto load = model.body.vector();
    model.body.load(0, *load);
    return StaticSolver(model.body, tightSettings(correction)).solve(*load);
  };
  auto const acceleration = [](Model const& model, Correction correction) {
    auto load = model.body.vector();
    model.body.load(0, *load);
    auto const state = slidingState(model);
    return initialAcceleration(model.body, model.fault, tightSettings(correction), *load,
                               {*state.u, *state.v, *model.body.vector(), {}},
                               {state.alpha, state.sigma_n});
  };
  EXPECT_LE(models.difference(*displacement(models.together, Correction::multigrid),
                              *displacement(models.alone, Correction::direct)),
            1e-9);
  EXPECT_LE(models.difference(*acceleration(models.together, Correction::multigrid),
                              *acceleration(models.alone, Correction::direct)),
            1e-9);
}
} // namespace asperity::dynamics
