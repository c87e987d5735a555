#pragma once

#include "base/Warning.hpp"
#include "scenario/problem/Problem.hpp"

#include <vector>

namespace asperity::scenario
{
// A warning for each Velocity or Plate Rate of a condition that exceeds somewhere, at any time,
// what is plausible: 1 m/s on a quasi-dynamic body, 10 m/s where waves are computed. Slip rates
// that are prescribed are not among them: those of an earthquake are as fast. Collective.
template <int Dim>
std::vector<Warning> warnOfDrive(Problem<Dim> const& problem);
} // namespace asperity::scenario
