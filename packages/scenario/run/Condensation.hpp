#pragma once

#include "dynamics/condensation/StaticCondensation.hpp"
#include "scenario/problem/Problem.hpp"

#include <memory>

namespace asperity::scenario
{
// The problem condensed to the unknowns of its fault. Null where the condensation is not exact, or
// where the deck switches it off (TNNMG / Static Condensation): the steps then solve the problem
// itself. `problem` must outlive the result.
template <int Dim>
std::unique_ptr<dynamics::StaticCondensation> makeCondensation(Problem<Dim> const& problem);
} // namespace asperity::scenario
