#pragma once

#include "arrangement/complex/Complex.hpp"
#include "building/BuildParameters.hpp"
#include "meshing/CellEstimate.hpp"
#include "meshing/CellSize.hpp"

#include <iosfwd>

namespace asperity::geometry
{
// Reports what a run of the deck of the settings, with its overlays, needs on this mesh: unknowns,
// memory, the time of a step, and how the size of cells compares with the cohesive zone, by the
// formulas of `asperity`. Friction is evaluated on the parts of faults in the body. Warnings go to
// stderr.
//
// InputError if the deck is wrong, or names a boundary that the mesh will not have.
void reportDeck(Complex const& complex, BuildSettings const& settings, CellSize const& size,
                CellEstimate const& cells, std::ostream& out);
} // namespace asperity::geometry
