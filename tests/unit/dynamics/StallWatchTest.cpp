#include "dynamics/watches/StallWatch.hpp"

#include "unit/base/Refusal.hpp"

#include <gtest/gtest.h>

namespace asperity::dynamics
{
namespace
{
constexpr StallWatch::Step forced{true, true, 100, 1e-3, 50};
} // namespace

TEST(StallWatch, EndsARunOfForcedStepsAlone)
{
  StallWatch watch(3);
  Notes notes;
  auto sound = forced;
  sound.is_forced = false;
  for (auto const& step : {forced, forced, sound, forced, forced}) {
    watch.note(step, notes);
    EXPECT_NO_THROW(watch.requireUsefulRun());
  }
  watch.note(forced, notes);
  asperity::test::expectRefusal<SolveError>([&] { watch.requireUsefulRun(); },
                                            {"the last 3 steps", "Most Forced Steps"});
  EXPECT_TRUE(notes.warnings.empty() && notes.lines.empty());
}

TEST(StallWatch, WarnsOfForcedStepsAndTellsOfSmallOnes)
{
  StallWatch watch(0);
  Notes notes;
  for (int i = 0; i < 100; ++i) {
    watch.note(forced, notes);
  }
  ASSERT_EQ(notes.warnings.size(), 1);
  EXPECT_EQ(notes.warnings.front().topic, "forced steps");
  asperity::test::expectParts(notes.warnings.front().text, {"The last 100 steps", "0.001 s"});
  auto sound = forced;
  sound.is_forced = false;
  for (int i = 100; i < 1000; ++i) {
    watch.note(sound, notes);
  }
  EXPECT_EQ(notes.warnings.size(), 1);
  ASSERT_EQ(notes.lines.size(), 1);
  asperity::test::expectParts(notes.lines.front(),
                              {"The last 1000 steps had the smallest size", "50000"});
}

TEST(StallWatch, GoesOnFromTheCountsOfAnEarlierRun)
{
  StallWatch before(3), after(3), finer(3);
  Notes notes;
  before.note(forced, notes);
  before.note(forced, notes);
  Archive memory;
  before.save(memory);
  after.restore(memory, {});
  after.note(forced, notes);
  EXPECT_THROW(after.requireUsefulRun(), SolveError);
  finer.restore(memory, {true});
  finer.note(forced, notes);
  EXPECT_NO_THROW(finer.requireUsefulRun());
}
} // namespace asperity::dynamics
