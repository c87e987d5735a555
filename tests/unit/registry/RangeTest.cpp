#include "registry/Range.hpp"

#include <gtest/gtest.h>

#include <limits>

using asperity::infinity;
using asperity::Range;

// Tables of laws are constant.
static_assert(Range::closedOpen(0, 90).contains(0) && !Range::closedOpen(0, 90).contains(90));
static_assert(!Range::positive().contains(0) && Range::atLeast(0).contains(0));

TEST(Range, HasFiniteNumbersAlone)
{
  for (auto const& range :
       {Range::any(), Range::atLeast(0), Range(-infinity, true, infinity, true)}) {
    EXPECT_FALSE(range.contains(infinity));
    EXPECT_FALSE(range.contains(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_TRUE(range.contains(1e300));
  }
}

TEST(Range, KeepsItsEnds)
{
  EXPECT_TRUE(Range::closed(0, 1).contains(0) && Range::closed(0, 1).contains(1));
  EXPECT_FALSE(Range::open(0, 1).contains(0) || Range::open(0, 1).contains(1));
  EXPECT_TRUE(Range::closedOpen(0, 1).contains(0) && !Range::closedOpen(0, 1).contains(1));
  EXPECT_TRUE(!Range::openClosed(0, 1).contains(0) && Range::openClosed(0, 1).contains(1));
  EXPECT_TRUE(Range::closed(1, 2).contains(2) && !Range::below(2).contains(2));
  EXPECT_TRUE(Range::positive().contains(1e-300) && !Range::positive().contains(0));
}

TEST(Range, IntersectionHasTheStricterBounds)
{
  const auto both = Range::closed(0, 2).intersection(Range::openClosed(0, 3));
  EXPECT_EQ(both.lower(), 0);
  EXPECT_EQ(both.upper(), 2);
  EXPECT_FALSE(both.hasLower());
  EXPECT_TRUE(both.hasUpper());
  EXPECT_FALSE(both.isEmpty());
  EXPECT_TRUE(Range::below(1).intersection(Range::atLeast(1)).isEmpty());
  EXPECT_FALSE(Range::closed(0, 1).intersection(Range::atLeast(1)).isEmpty());
}
