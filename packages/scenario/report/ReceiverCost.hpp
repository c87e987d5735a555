#pragma once

#include "dynamics/condensation/VertexMotion.hpp"

#include <string>

namespace asperity::scenario
{
// For the log: what the motion of the body at receivers costs in a condensed run, and what to do if
// it costs as much as that of the whole body; "" without receivers. Receivers on the fault have
// rows, too.
std::string describeReceiverCost(dynamics::RecoveryCost const& cost);
} // namespace asperity::scenario
