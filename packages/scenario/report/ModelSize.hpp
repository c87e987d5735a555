#pragma once

#include "scenario/problem/Problem.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The largest memory that this process has used so far.
double peakBytes();

// Lines about size: cells, vertices and unknowns; the diameters of cells as they are; the memory of
// the model as built, and an estimate of that of the solver. Collective.
template <int Dim>
std::vector<std::string> describeSize(Problem<Dim> const& problem);
} // namespace asperity::scenario
