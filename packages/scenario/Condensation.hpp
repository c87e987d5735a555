#pragma once

#include "dynamics/condensation/StaticCondensation.hpp"
#include "scenario/Problem.hpp"

#include <memory>

namespace asperity::scenario
{
// What the steps of a run need to know of a problem, condensed to its fault. Null where that is not
// exact, or the deck does not want it (TNNMG / Static Condensation): then the problem itself is the
// model. `problem` must outlive the result.
template <int Dim>
std::unique_ptr<dynamics::StaticCondensation> makeCondensation(Problem<Dim> const& problem,
                                                               ParameterList const& deck);
} // namespace asperity::scenario
