#pragma once

#include "base/Warning.hpp"
#include "dynamics/coupling/CouplingSettings.hpp"
#include "scenario/setup/TimeSetup.hpp"

#include <vector>

namespace asperity::scenario
{
// Warnings where the tolerance of the steps is looser than decks have, and where that of the
// fixed-point iteration is above it.
std::vector<Warning> warnOfTolerances(TimeSettings const& time,
                                      dynamics::CouplingSettings const& coupling);
} // namespace asperity::scenario
