#include "scenario/report/ReceiverCost.hpp"

namespace asperity::scenario
{
std::string describeReceiverCost(dynamics::RecoveryCost const& cost)
{
  const std::string of_body = std::to_string(cost.of_body);
  std::string text;
  if (cost.num_rows > 0) {
    text = "Receivers: " + std::to_string(cost.num_rows) + " times " +
           std::to_string(cost.row_length) +
           " products give the motion of the body at them, instead of " + of_body +
           " for the whole body.";
  }
  if (cost.are_refused) {
    text += std::string(text.empty() ? "" : " ") +
            "Receivers: there are so many that every row computes the motion of the whole body, " +
            of_body +
            " products for each field. Choose fewer receivers, or a larger Every n Steps.";
  }
  return text;
}
} // namespace asperity::scenario
