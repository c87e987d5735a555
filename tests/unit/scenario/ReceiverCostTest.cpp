#include "scenario/report/ReceiverCost.hpp"

#include <gtest/gtest.h>

namespace asperity::scenario
{
TEST(ReceiverCost, SaysWhatRowsCostAndWhatToDoWithoutThem)
{
  EXPECT_EQ(describeReceiverCost({0, 40, 5000, false}), "");
  const std::string rows = "Receivers: 3 times 40 products give the motion of the body at them, "
                           "instead of 5000 for the whole body.";
  EXPECT_EQ(describeReceiverCost({3, 40, 5000, false}), rows);
  const std::string refused = "Receivers: there are so many that every row computes the motion of "
                              "the whole body, 5000 products for each field. Choose fewer "
                              "receivers, or a larger Every n Steps.";
  EXPECT_EQ(describeReceiverCost({0, 40, 5000, true}), refused);
  EXPECT_EQ(describeReceiverCost({3, 40, 5000, true}), rows + " " + refused);
}
} // namespace asperity::scenario
