#pragma once

#include "dynamics/rate/RateSolver.hpp"
#include "parameters/Parameters.hpp"
#include "tnnmg/TnnmgSettings.hpp"

#include <cstddef>
#include <string>

namespace asperity::scenario
{
// The deck's list `TNNMG`.
RCP<const ParameterList> solverParameters();

// The value of `Linear Correction`.
enum class CorrectionChoice
{
  automatic,
  direct,
  multigrid
};

// What the list says.
struct SolverSettings
{
  CorrectionChoice correction = CorrectionChoice::automatic;
  bool may_condense = true; // the body to its fault, where that is exact
  double memory = 2000;     // of each rank for solvers of step sizes [MB]
  tnnmg::TnnmgSettings tnnmg;
  ParameterList multigrid; // the list `Multigrid`, which tnnmg::MultigridCorrection reads

  static SolverSettings from(ParameterList const& list);

  std::size_t memoryBudget() const; // `memory` in bytes
};

// `Auto` becomes the direct correction on one rank with up to 100,000 unknowns in two dimensions of
// space or 10,000 in three, and multigrid otherwise.
dynamics::RateSolverSettings makeSolverSettings(SolverSettings const& settings, int num_ranks,
                                                int dimension, long long num_unknowns);

// A sentence for the log on the cost of `Direct` where `Auto` would choose multigrid; "" elsewhere.
// It does not hold for a condensed body, which has a single factor for all step sizes.
std::string hintOnDirect(SolverSettings const& settings, int dimension, long long num_unknowns);
} // namespace asperity::scenario
