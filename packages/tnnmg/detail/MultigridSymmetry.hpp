#pragma once

#include "tnnmg/detail/MultigridOperator.hpp"

namespace asperity::tnnmg::detail
{
// Numbers in [-1, 1) that depend on global id and seed (0 or 1) alone, and zero at dofs that are
// not left.
Vector pseudorandomVector(RCP<const Map> const& map, int seed, MultigridNodes const& nodes);

// |<Bx, y> - <x, By>| / sqrt(<Bx, x> <By, y>) for two pseudorandom vectors. Infinite if B is not
// positive there. Applies B twice.
double relativeAsymmetry(Operator const& B, MultigridNodes const& nodes);

// Throws SolveError on all ranks if B is not symmetric to 1e-8 and positive. Conjugate gradients
// would stall with it.
void requireSymmetric(Operator const& B, MultigridNodes const& nodes);
} // namespace asperity::tnnmg::detail
