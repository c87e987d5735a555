#include "dynamics/control/PrescribedSteps.hpp"
#include "dynamics/control/StepDoubling.hpp"
#include "dynamics/coupling/StateUpdate.hpp"
#include "unit/base/Refusal.hpp"
#include "unit/dynamics/ControlTest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace asperity::dynamics
{
using namespace dynamics::test;

namespace
{
class StepControlTest : public ControlTest
{
};

// The normal stress as an unknown of a step, of which 1 Pa counts as 0.01 of alpha.
class StressOfTest : public StepUnknown
{
public:
  explicit StressOfTest(int num_nodes) : scale_("scale", num_nodes)
  {
    Kokkos::deep_copy(scale_, 0.01);
  }
  NodeView valuesIn(State const& state) const override { return state.sigma_n; }
  int respond(StepIterate const&, NodeView const&) override { return 0; }
  ConstNodeView scale() const override { return scale_; }

private:
  NodeView scale_;
};
} // namespace

TEST_F(StepControlTest, MeasuresEachUnknownOnItsScale)
{
  const StepUnknowns unknowns(*model.surface, 2,
                              {std::make_shared<StateUpdate>(model.fault),
                               std::make_shared<StressOfTest>(model.surface->numNodes())});
  auto other = state.clone();
  other.alpha = model.nodeView([](Point<2> const& x) { return -1.25 + std::sin(9 * x[0]); });
  for (Norm norm : {Norm::root_mean_square, Norm::maximum}) {
    EXPECT_NEAR(unknowns.distance(state, other, norm), 0.25, 1e-12);
  }
  other.sigma_n = model.nodeView([](Point<2> const&) { return 1040; });
  state.sigma_n = model.nodeView([](Point<2> const&) { return 1000; });
  for (Norm norm : {Norm::root_mean_square, Norm::maximum}) {
    EXPECT_NEAR(unknowns.distance(state, other, norm), 0.4, 1e-12);
  }
}

TEST_F(StepControlTest, DoublingAcceptsTheCoarsestStepThatIsFineEnough)
{
  const double tolerance = 1e-4;
  StepDoubling control({stepper.step}, adaptive(tolerance, 4));
  SolveCount count;
  int coarsest = 16, finest = 0;
  for (int n = 1; n <= 30; ++n) {
    auto const before = state.clone();
    auto const accepted = control.advance(state, count);
    coarsest = std::min(coarsest, accepted.level);
    finest = std::max(finest, accepted.level);
    ASSERT_GT(accepted.level, 0);
    EXPECT_TRUE(accepted.within_tolerance);
    EXPECT_LE(accepted.error, tolerance);
    EXPECT_NEAR(accepted.error, errorOf(before, accepted.level), 1e-10);
    EXPECT_GT(errorOf(before, accepted.level - 1), tolerance);
    EXPECT_EQ(state.time, before.time + half_seconds.ticks(accepted.level));
    EXPECT_LE(difference(state, stepped(before, {accepted.level})), 1e-10);
    EXPECT_EQ(control.memory().num_steps, n);
    if (auto const& trial = control.memory().trial) {
      EXPECT_LE(difference(trial->state, stepped(state, {control.memory().level})), 1e-10);
    }
  }
  EXPECT_GE(finest - coarsest, 2) << "the run was meant to need several step sizes";
}

TEST_F(StepControlTest, DoublingComesToTheSameStepFromAnyFirstTrial)
{
  const double tolerance = 1e-4;
  std::vector<int> levels;
  for (int first : {1, 7, 16}) {
    auto from = state.clone();
    StepDoubling control({stepper.step}, adaptive(tolerance, first));
    SolveCount count;
    levels.push_back(control.advance(from, count).level);
  }
  EXPECT_EQ(levels[0], levels[1]);
  EXPECT_EQ(levels[1], levels[2]);
}

TEST_F(StepControlTest, DoublingContinuesFromItsMemoryExactly)
{
  StepDoubling control({stepper.step}, adaptive(1e-4, 8));
  SolveCount count;
  for (int n = 0; n < 7; ++n) {
    control.advance(state, count);
  }
  Stepper other(model, RateUpdate::newmark(0.25), half_seconds);
  StepDoubling continued({other.step}, adaptive(1e-4, 8));
  expectSameContinuation(control, state, continued, 7);
}

TEST_F(StepControlTest, DoublingHalvesStepsThatCannotBeSolved)
{
  // One iteration of the fixed point has to do: that takes steps far finer than the tolerance does.
  Stepper hasty(model, RateUpdate::newmark(0.25), half_seconds, coupling(1e-3, 1));
  StepDoubling control({hasty.step}, adaptive(1e-2, 2));
  StepDoubling free({stepper.step}, adaptive(1e-2, 2));
  expectSmallerSteps(control, free);
}

TEST_F(StepControlTest, DoublingGivesUpBelowTheSmallestStep)
{
  Stepper hasty(model, RateUpdate::newmark(0.25), half_seconds, coupling(1e-12, 1));
  StepDoubling control({hasty.step}, adaptive(1e-2, 2, 5));
  SolveCount count;
  asperity::test::expectRefusal<SolveError>([&] { control.advance(state, count); },
                                            {"t = 0 s", "0.015625 s"});
  EXPECT_EQ(state.time, 0);
}

TEST_F(StepControlTest, DoublingSaysWhenTheSmallestStepIsTooCoarse)
{
  StepDoubling control({stepper.step}, adaptive(1e-12, 4, 6));
  SolveCount count;
  auto const accepted = control.advance(state, count);
  EXPECT_EQ(accepted.level, 6);
  EXPECT_FALSE(accepted.within_tolerance);
  EXPECT_GT(accepted.error, 1e-12);
}

TEST_F(StepControlTest, DoublingStaysBelowTheLargestStep)
{
  auto settings = adaptive(1e3, 8);
  settings.coarsest_level = 5;
  StepDoubling control({stepper.step}, settings);
  SolveCount count;
  for (int n = 1; n <= 3; ++n) {
    auto const before = state.clone();
    EXPECT_EQ(control.advance(state, count).level, 5);
    EXPECT_EQ(state.time, n * half_seconds.ticks(5));
    EXPECT_LE(difference(state, stepped(before, {5})), 1e-10);
  }
}

TEST_F(StepControlTest, DoublingMeasuresInTheNormAskedFor)
{
  auto settings = adaptive(1e-4, 8);
  settings.norm = Norm::maximum;
  for (int first : {4, 12}) { // from a step too coarse, and from one too fine
    settings.first_level = first;
    auto from = state.clone();
    StepDoubling control({stepper.step}, settings);
    SolveCount count;
    auto const accepted = control.advance(from, count);
    EXPECT_NEAR(accepted.error, errorOf(state, accepted.level, Norm::maximum), 1e-10);
    EXPECT_GT(errorOf(state, accepted.level - 1, Norm::maximum), settings.tolerance);
  }
}

TEST_F(StepControlTest, PrescribedStepsAreTakenAndTheLastRepeated)
{
  PrescribedSteps control({stepper.step}, {8, 7, 9});
  SolveCount count;
  auto const expected = stepped(state, {8, 7, 9, 9});
  for (int level : {8, 7, 9, 9}) {
    EXPECT_EQ(control.advance(state, count).level, level);
  }
  EXPECT_EQ(state.time, expected.time);
  EXPECT_LE(difference(state, expected), 1e-12);
  EXPECT_EQ(control.memory().num_steps, 4);
  EXPECT_EQ(count.coupled_steps, 4);
}

TEST_F(StepControlTest, DoublingMeetsInstants)
{
  auto settings = adaptive(1e3, 8);
  settings.coarsest_level = 8;
  StepDoubling control(meeting(several_instants), settings);
  expectInstantsMet(control);
}

TEST_F(StepControlTest, DoublingDoesNotKnowOfInstantsFarAway)
{
  StepDoubling control(meeting(far_instant), adaptive(1e-4, 8));
  StepDoubling free({stepper.step}, adaptive(1e-4, 8));
  expectSameStepsFarFromInstants(control, free);
}

TEST_F(StepControlTest, DoublingContinuesBeforeAnInstantExactly)
{
  auto settings = adaptive(1e3, 8);
  settings.coarsest_level = 8;
  StepDoubling control(meeting(near_instant), settings);
  StepDoubling continued(meeting(near_instant), settings);
  expectContinuationBeforeAnInstant(control, continued);
}

TEST_F(StepControlTest, PrescribedStepsMeetInstants)
{
  PrescribedSteps control(meeting(several_instants), {8});
  expectInstantsMet(control);
}

TEST_F(StepControlTest, ATrialBeyondANewInstantIsForgotten)
{
  StepDoubling control({stepper.step}, adaptive(1e-4, 8));
  SolveCount count;
  do {
    control.advance(state, count);
  } while (!control.memory().trial);
  auto const instant = control.memory().trial->state.time - 1;
  Archive archive;
  control.save(archive, states);
  StepDoubling restarted(meeting({instant}), adaptive(1e-4, 8));
  restarted.restore(archive, states);
  auto const times = timesUpTo(restarted, {instant});
  EXPECT_EQ(times.back(), instant);
}

TEST_F(StepControlTest, PrescribedStepsThatFailEndTheRun)
{
  Stepper hasty(model, RateUpdate::newmark(0.25), half_seconds, coupling(1e-12, 1));
  PrescribedSteps control({hasty.step}, {3});
  SolveCount count;
  const auto message = asperity::test::refusal<SolveError>([&] { control.advance(state, count); });
  asperity::test::expectParts(message, {"as prescribed, failed", "'Prescribed / Levels'"});
  EXPECT_EQ(message.find("'Smallest Step'"), std::string::npos) << message;
  EXPECT_EQ(state.time, 0);
}

TEST_F(StepControlTest, NamesTheNumberThatWasLost)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(firstNotFinite(state));
  state.u->putScalar(nan);
  const auto found = firstNotFinite(state);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->field, "displacement");
  EXPECT_EQ(found->index, 0);
  ControlContext context{stepper.step};
  context.place_of = [](int vertex) { return "vertex " + std::to_string(vertex); };
  StepDoubling control(context, adaptive(1e-4, 16));
  SolveCount count;
  asperity::test::expectRefusal<SolveError>([&] { control.advance(state, count); },
                                            {"nan at vertex "});
}

TEST_F(StepControlTest, FindsInfinityInEachField)
{
  const double infinity = std::numeric_limits<double>::infinity();
  auto lost = state.clone();
  Kokkos::deep_copy(lost.alpha, -infinity);
  EXPECT_EQ(firstNotFinite(lost)->field, "alpha");
  EXPECT_EQ(firstNotFinite(lost)->place, NotFinite::Place::fault);
  lost.a->replaceLocalValue(1, infinity);
  EXPECT_EQ(firstNotFinite(lost)->field, "acceleration");
  EXPECT_EQ(firstNotFinite(lost)->index, 1);
}
} // namespace asperity::dynamics
