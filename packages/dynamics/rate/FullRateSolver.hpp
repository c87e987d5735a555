#pragma once

#include "dynamics/rate/RateSolver.hpp"

#include <memory>

namespace asperity::dynamics
{
// A solver that runs TNNMG on all dofs of all ranks. reactions: see makeRateSolver.
std::unique_ptr<RateSolver>
makeFullRateSolver(RCP<const CrsMatrix> const& Z, tnnmg::NonlinearNodes const& nodes,
                   std::shared_ptr<tnnmg::MultigridCorrection> const& correction,
                   tnnmg::TnnmgSettings const& settings, RCP<const CrsMatrix> const& reactions);
} // namespace asperity::dynamics
