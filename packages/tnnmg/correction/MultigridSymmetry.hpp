#pragma once

#include "tnnmg/correction/MultigridOperator.hpp"

namespace asperity::tnnmg::detail
{
// Numbers in [-1, 1) that depend on global id and seed (0 or 1) alone; they are zero at removed and
// constrained dofs.
Vector pseudorandomVector(RCP<const Map> const& map, int seed, MultigridNodes const& nodes);

// |<Bx, y> - <x, By>| / sqrt(<Bx, x> <By, y>) for two pseudorandom vectors. The result is infinite
// if B is not positive at these vectors. Applies B twice.
double relativeAsymmetry(Operator const& B, MultigridNodes const& nodes);

// Throws SolveError on all ranks if B is not symmetric to the tolerance and positive, because
// conjugate gradients would stall.
void requireSymmetric(Operator const& B, MultigridNodes const& nodes, double tolerance);
} // namespace asperity::tnnmg::detail
