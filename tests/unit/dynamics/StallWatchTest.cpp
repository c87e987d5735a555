#include "dynamics/control/StallWatch.hpp"

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
  EXPECT_EQ(watch.note(forced), "");
  EXPECT_EQ(watch.note(forced), "");
  auto sound = forced;
  sound.is_forced = false;
  EXPECT_EQ(watch.note(sound), "");
  EXPECT_EQ(watch.memory().forced, 0);
  EXPECT_EQ(watch.memory().smallest, 3);
}

TEST(StallWatch, GoesOnFromTheCountsOfAnEarlierRun)
{
  StallWatch before(3), after(3);
  before.note(forced);
  before.note(forced);
  after.restore(before.memory());
  test::expectRefusal<SolveError>([&] { after.note(forced); },
                                  {"the last 3 steps", "Most Forced Steps"});
}
} // namespace asperity::dynamics
