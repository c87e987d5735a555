#pragma once

#include "base/Warning.hpp"
#include "scenario/problem/Problem.hpp"

#include <vector>

namespace asperity::scenario
{
// A warning for each boundary of the entry `Mesh / Flat Cells Beside` along which slip is
// prescribed and ends inside the body: flat cells do not improve the response of the body there.
// Collective.
template <int Dim>
std::vector<Warning> warnOfFlatCells(Problem<Dim> const& problem);
} // namespace asperity::scenario
