#include "scenario/checks/StartCheck.hpp"

#include "SampleDeck.hpp"

namespace asperity::scenario
{
using namespace test;

TEST(StartCheck, WarnsOfForcesOutOfBalanceAndOfFrictionWithTheLoad)
{
  EXPECT_TRUE(warnOfStart(0, 0).empty());
  EXPECT_TRUE(warnOfStart(0.0099, 0.49).empty()) << "a patch may start against the load";
  auto const out_of_balance = warnOfStart(0.02, 0);
  ASSERT_EQ(out_of_balance.size(), 1u);
  EXPECT_EQ(out_of_balance[0].topic, "start out of balance");
  expectParts(out_of_balance[0].text, {"0.02 of the forces", "at most 0.01", "Stress Balance"});
  auto const with_load = warnOfStart(0, 0.7531);
  ASSERT_EQ(with_load.size(), 1u);
  EXPECT_EQ(with_load[0].topic, "friction at the start");
  expectParts(with_load[0].text, {"over 75.3 % of the fault", "Friction / Shear Traction"});
  EXPECT_EQ(warnOfStart(0.02, 0.7).size(), 2u);
}
} // namespace asperity::scenario
