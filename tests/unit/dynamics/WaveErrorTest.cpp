#include "dynamics/control/WaveError.hpp"

#include "dynamics/control/RichardsonControl.hpp"
#include "dynamics/control/StepDoubling.hpp"
#include "unit/dynamics/ControlTest.hpp"
#include "unit/dynamics/QuasiDynamicModel.hpp"

#include <algorithm>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
constexpr double rate = 2e-3, weight = 0.5; // m/s, -

// The sliding block; in the second state one dof off the fault has another jerk and acceleration.
class WaveErrorTest : public ControlTest
{
protected:
  WaveErrorTest() : ControlTest(RateUpdate::generalisedAlpha(0.5)), later(state.clone())
  {
    for (auto* s : {&state, &later}) {
      s->a->putScalar(3);
      s->jerk->putScalar(7);
    }
  }

  // Of a free dof and of one that is held.
  void change(int dof, double by)
  {
    later.a->sumIntoLocalValue(dof, by);
    later.jerk->sumIntoLocalValue(dof, 10 * by);
  }
  int freeDof() const
  {
    auto const& held = model.body.held.owned();
    int dof = 0;
    while (std::find(held.begin(), held.end(), dof) != held.end()) {
      ++dof;
    }
    return dof;
  }
  double error(RateUpdate const& update, double tau, WaveScale const& scale = {rate, weight}) const
  {
    return WaveError(model.body, *model.surface, update, scale).errorBetween(state, later, tau);
  }

  State later;
  static constexpr double peak = 0.8 * loading_rate; // of slidingState() at x = 0.3
};
} // namespace

TEST_F(WaveErrorTest, IsTheLargestChangeOfAccelerationOrJerkOnItsScale)
{
  change(freeDof(), -4);
  const double S = rate + peak, c = 1. / 12 + 1. / 6;
  const double factor = model.surface->slipFactor();
  EXPECT_NEAR(error(RateUpdate::generalisedAlpha(0.5), 0.1), weight * factor * c * 0.01 * 40 / S,
              1e-12);
  EXPECT_NEAR(error(RateUpdate::backwardEuler(), 0.1), weight * factor * 0.5 * 0.1 * 4 / S, 1e-12);
}

TEST_F(WaveErrorTest, LeavesOutWhatIsPrescribedAndWhatDoesNotCount)
{
  change(model.body.held.owned().front(), 5);
  EXPECT_EQ(error(RateUpdate::generalisedAlpha(0.5), 0.1), 0);
  change(freeDof(), 5);
  EXPECT_GT(error(RateUpdate::generalisedAlpha(0.5), 0.1), 0);
  EXPECT_EQ(error(RateUpdate::newmark(0.25), 0.1), 0);
  EXPECT_EQ(error(RateUpdate::generalisedAlpha(0.5), 0.1, {0, 1}), 0);
  EXPECT_EQ(error(RateUpdate::generalisedAlpha(0.5), 0.1, {rate, 0}), 0);
}

TEST_F(WaveErrorTest, LeavesOutABodyWithoutMass)
{
  change(freeDof(), 5);
  auto const massless = quasiDynamic(model);
  const WaveError waves(massless.body, *model.surface, stepper.step.update(), {rate, weight});
  EXPECT_EQ(waves.errorBetween(state, later, 0.1), 0);
}

// With a weight that leaves nothing else to see.
TEST_F(WaveErrorTest, IsInTheErrorsOfControls)
{
  auto settings = adaptive(1e6, 8);
  settings.waves = {rate, 1e3};
  const WaveError waves(model.body, *model.surface, stepper.step.update(), settings.waves);
  auto const before = slidingState(model);
  SolveCount count;

  settings.coarsest_level = 7; // of the step that a pair is compared with
  RichardsonControl richardson({stepper.step}, settings);
  auto end = before.clone();
  auto accepted = richardson.advance(end, count);
  richardson.advance(end, count);
  EXPECT_GT(accepted.error, 0.1);
  EXPECT_EQ(accepted.error, waves.errorBetween(before, end, half_seconds.stepSize(8)));

  settings.coarsest_level = 8;
  StepDoubling doubling({stepper.step}, settings);
  end = before.clone();
  accepted = doubling.advance(end, count);
  EXPECT_GT(accepted.error, 0.1);
  EXPECT_EQ(accepted.error, waves.errorBetween(before, end, half_seconds.stepSize(8)));
}
} // namespace asperity::dynamics
