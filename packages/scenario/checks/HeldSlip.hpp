#pragma once

#include "scenario/checks/Description.hpp"
#include "scenario/problem/Problem.hpp"

namespace asperity::scenario
{
// Where a fault with friction ends on another boundary whose condition prescribes all its slip: a
// line with the number of nodes, the boundary and the largest slip rate, or a warning if that rate
// is zero. Tips, and edges where the fault is continued at a given slip rate, are left out.
// Collective.
template <int Dim>
void describeHeldSlip(Problem<Dim> const& problem, Description& description);
} // namespace asperity::scenario
