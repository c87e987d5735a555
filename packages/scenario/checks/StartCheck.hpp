#pragma once

#include "base/Warning.hpp"

#include <vector>

namespace asperity::scenario
{
// Warns where more than a hundredth of the forces at the start is not balanced, and where friction
// acts with the load over more than half of the fault. imbalance, contradiction: of
// dynamics::startImbalance and startContradiction [-].
std::vector<Warning> warnOfStart(double imbalance, double contradiction);
} // namespace asperity::scenario
