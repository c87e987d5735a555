#include "scenario/report/ReceiverCost.hpp"

namespace asperity::scenario
{
std::string describeReceiverCost(dynamics::RecoveryRows const& rows)
{
  const std::string of_body = std::to_string(rows.productsOfBody());
  std::string text;
  if (rows.size() > 0) {
    text = "Receivers: " + std::to_string(rows.size()) + " times " + std::to_string(rows.length()) +
           " products give the motion of the body at them, instead of " + of_body +
           " for the whole body.";
  }
  if (rows.haveBeenRefused()) {
    text += std::string(text.empty() ? "" : " ") +
            "Receivers: there are so many that every row computes the motion of the whole body, " +
            of_body +
            " products for each field. Choose fewer receivers, or a larger Every n Steps.";
  }
  return text;
}
} // namespace asperity::scenario
