#pragma once

#include "dynamics/rate/RateSolver.hpp"

#include <memory>

namespace asperity::dynamics
{
// A solver that eliminates all dofs but those of the fault, exactly, before and after TNNMG runs on
// the fault. order: of the elimination; it is chosen where it is empty. reactions: see
// makeRateSolver. On one rank.
std::unique_ptr<RateSolver> makeCondensedRateSolver(CrsMatrix const& Z,
                                                    fem::FaultSurface const& surface,
                                                    tnnmg::TnnmgSettings const& settings,
                                                    RCP<const CrsMatrix> const& reactions,
                                                    tnnmg::EliminationOrder& order);
} // namespace asperity::dynamics
