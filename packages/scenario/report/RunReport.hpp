#pragma once

#include "scenario/checks/Description.hpp"
#include "scenario/problem/Problem.hpp"

namespace asperity::scenario
{
// Lines for the log about the machine, the model and how well the mesh resolves it, and warnings.
// Collective.
template <int Dim>
Description describe(Problem<Dim> const& problem);
} // namespace asperity::scenario
