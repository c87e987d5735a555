#include "dynamics/watches/GrowthWatch.hpp"

#include "dynamics/watches/SlowSlip.hpp"
#include "unit/base/Refusal.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace asperity::dynamics
{
namespace
{
constexpr double L = 1e-5;

// A step at whose end the rate is `rate`.
GrowthWatch::Step step(bool is_forced, double size, double before, double rate)
{
  return {is_forced, 100, size, before, rate};
}
} // namespace

TEST(GrowthWatch, WarnsOfAForcedStepInWhichTheRateGrowsAndSlipsByAPartOfL)
{
  GrowthWatch watch(L, 0);
  const auto warning = watch.note(step(true, 1e4, 1e-9, 2.8e-5));
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->topic, "hidden growth");
  asperity::test::expectParts(warning->text,
                              {"1 step of the smallest size 10000 s", "2.8e-05 m/s"});
}

TEST(GrowthWatch, IsSilentWhereNothingIsHidden)
{
  // no growth by a factor of two; slip of less than L / 10; a rate that falls
  for (const bool is_forced : {true, false}) {
    for (auto const& calm : {step(is_forced, 1e4, 1e-9, 1.9e-9), step(is_forced, 1e-7, 0.01, 1),
                             step(is_forced, 1e4, 2.8e-5, 1e-9)}) {
      EXPECT_FALSE(GrowthWatch(L, 1).note(calm));
    }
  }
}

TEST(GrowthWatch, BlamesTheToleranceWhereAStepThatMeetsItHidesGrowth)
{
  GrowthWatch watch(L, 2);
  const auto warning = watch.note(step(false, 1e4, 1e-9, 2.8e-5));
  ASSERT_TRUE(warning);
  asperity::test::expectParts(warning->text,
                              {"1 step within the tolerance", "Choose a smaller 'Tolerance'"});
  EXPECT_TRUE(watch.note(step(true, 1e4, 1e-9, 2.8e-5))) << "forced steps are counted apart";
  EXPECT_NO_THROW(watch.requireUsefulRun());
  watch.note(step(false, 1e4, 1e-9, 2.8e-5));
  EXPECT_THROW(watch.requireUsefulRun(), SolveError);
}

TEST(GrowthWatch, SeesGrowthOverManyForcedSteps)
{
  GrowthWatch watch(L, 0);
  EXPECT_FALSE(watch.note(step(true, 1e4, 1e-9, 1.5e-9)));
  EXPECT_TRUE(watch.note(step(true, 1e4, 1.5e-9, 2.1e-9))); // above twice the first rate
}

TEST(GrowthWatch, BeginsAnewAfterAStepThatIsNotForced)
{
  GrowthWatch watch(L, 0);
  EXPECT_FALSE(watch.note(step(true, 1e4, 1e-9, 1.5e-9)));
  EXPECT_FALSE(watch.note(step(false, 1e4, 1.5e-9, 1.5e-9)));
  EXPECT_FALSE(watch.note(step(true, 1e4, 1.5e-9, 2.1e-9)));
}

TEST(GrowthWatch, EndsTheRunWithOneTooMany)
{
  GrowthWatch watch(L, 3);
  EXPECT_TRUE(watch.note(step(true, 1, 1e-9, 1)));
  EXPECT_FALSE(watch.note(step(true, 1, 1e-9, 1)));
  EXPECT_NO_THROW(watch.requireUsefulRun());
  EXPECT_TRUE(watch.note(step(true, 1, 1e-9, 1))) << "what ends a run is a warning, too";
  EXPECT_THROW(watch.requireUsefulRun(), SolveError);
}

TEST(GrowthWatch, GoesOnFromTheCountsOfAnEarlierRun)
{
  GrowthWatch before(L, 0);
  before.note(step(true, 1, 1e-9, 1.5e-9));
  for (const bool is_forced : {true, false, false}) {
    before.note(step(is_forced, 1, 1e-9, 1));
  }
  before.note(step(true, 1e-7, 1e-9, 1.5e-9));
  EXPECT_EQ(before.memory().forced, 1);
  EXPECT_EQ(before.memory().others, 2);

  GrowthWatch after(L, 3);
  Archive memory;
  before.save(memory);
  after.restore(memory, {});
  EXPECT_NO_THROW(after.requireUsefulRun());
  EXPECT_FALSE(after.note(step(true, 1e4, 1.5e-9, 2.1e-9)));
  EXPECT_EQ(after.memory().forced, 2) << "above twice the first rate, 1e-9";
  EXPECT_TRUE(after.note(step(true, 1e4, 2.1e-9, 2.2e-9)));
  EXPECT_THROW(after.requireUsefulRun(), SolveError);

  GrowthWatch full(L, 2);
  full.restore(memory, {});
  asperity::test::expectRefusal<UselessRun>([&] { full.requireUsefulRun(); },
                                            {"2 steps before this restart", "a smaller 'Tolerance'",
                                             "begin a new run", "Most Hiding Steps"});
}

TEST(GrowthWatch, ForgetsForcedStepsWhereARestartHasSmallerSteps)
{
  GrowthWatch before(L, 0), after(L, 1);
  before.note(step(true, 1, 1e-9, 1));
  Archive memory;
  before.save(memory);
  after.restore(memory, {true});
  EXPECT_EQ(after.memory().forced, 0);
  EXPECT_LT(after.memory().least, 0);
  EXPECT_NO_THROW(after.requireUsefulRun());
}

TEST(GrowthWatch, TakesPrescribedStepsForForcedAndEndsNoRun)
{
  GrowthWatch watch(L, 1, true);
  EXPECT_FALSE(watch.note(step(false, 1e-7, 0.01, 1))) << "slip of less than L / 10";
  const auto warning = watch.note(step(false, 1, 1e-9, 1e-3));
  ASSERT_TRUE(warning);
  asperity::test::expectParts(warning->text, {"1 step of the prescribed size 1 s"});
}

TEST(GrowthWatch, KnowsNoSlipDistance)
{
  EXPECT_TRUE(GrowthWatch(0, 0).note(step(true, 1e-7, 1e-9, 1)));
  EXPECT_FALSE(GrowthWatch(0, 0).note(step(false, 1e4, 1e-9, 1)));
  EXPECT_FALSE(GrowthWatch(0, 0, true).note(step(false, 1e4, 1e-9, 1)));
}

// Four nodes of each rank: one does not weaken, one slips fast.
TEST(SlowSlip, IsTheLargestOfWeakeningNodesWhoseSlipIsSlow)
{
  const auto world = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
  const double last = world->getRank() + 1 == world->getSize() ? 1 : 0.5;
  const SlowSlip slip({L, 0, 2 * L, L}, 1e-3);
  const auto V =
    toDevice(std::vector<double>{1e-9, 1e-4, last * 1e-8, 0.5}, "asperity::test::rates");
  EXPECT_DOUBLE_EQ(slip.largestRatio(V, 1e4, *world), 1e-8 * 1e4 / (2 * L));
  EXPECT_EQ(SlowSlip({}, 0).largestRatio(V, 1e4, *world), 0);
}

TEST(GrowthWatch, TellsOfSlowSlipOfMoreThanTwoL)
{
  GrowthWatch watch(L, 1);
  auto creep = step(false, 4, 5e-5, 5e-5);
  creep.slow_slip = 1.9;
  EXPECT_FALSE(watch.note(creep));
  creep.slow_slip = 8;
  const auto warning = watch.note(creep);
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->topic, "hidden growth");
  asperity::test::expectParts(warning->text,
                              {"1 step", "4 s", "(8 L)", "Choose a smaller 'Tolerance'"});
  EXPECT_FALSE(watch.note(creep)) << "the 10th is the next";
  EXPECT_NO_THROW(watch.requireUsefulRun());
}
} // namespace asperity::dynamics
