#pragma once

#include "base/Parameters.hpp"
#include "dynamics/RateSolver.hpp"

namespace asperity::scenario
{
// The deck's list `TNNMG`.
RCP<const ParameterList> solverParameters();

// `Auto` becomes the direct correction on one rank up to some 100,000 unknowns, and multigrid
// beyond.
dynamics::RateSolverSettings makeSolverSettings(ParameterList const& list, int num_ranks,
                                                long long num_unknowns);

std::size_t memoryBudget(ParameterList const& list); // bytes
} // namespace asperity::scenario
