#pragma once

#include "dynamics/coupling/RateSolver.hpp"
#include "parameters/Parameters.hpp"

#include <string>

namespace asperity::scenario
{
// The deck's list `TNNMG`.
RCP<const ParameterList> solverParameters();

// `Auto` becomes the direct correction on one rank with up to 100,000 unknowns in two dimensions of
// space or 10,000 in three, and multigrid otherwise.
dynamics::RateSolverSettings makeSolverSettings(ParameterList const& list, int num_ranks,
                                                int dimension, long long num_unknowns);

// For the log: what `Direct` costs where `Auto` would choose multigrid; "" elsewhere. A body that
// is condensed has one factor in all, which costs less.
std::string hintOnDirect(ParameterList const& list, int dimension, long long num_unknowns);

// Whether a body may be condensed to its fault.
bool mayCondense(ParameterList const& list);

std::size_t memoryBudget(ParameterList const& list); // of each rank, in bytes
} // namespace asperity::scenario
