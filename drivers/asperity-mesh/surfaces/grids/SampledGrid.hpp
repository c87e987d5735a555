#pragma once

#include "surfaces/TriangleSurface.hpp"
#include "surfaces/grids/Grid.hpp"
#include "surfaces/kinds/SurfaceKinds.hpp"
#include "surfaces/kinds/Units.hpp"

namespace asperity::geometry
{
// The surface through the crossings of a grid, z in m, where it has values; of lines that are
// closer than `step` [m] some are left out.
TriangleSurface surfaceOf(Grid const& grid, Units const& units, double step);

// The surface over an area of the model, at points `step` [m] apart, or less so that they end at
// its edges; 0: as far apart as lines of the grid. InputError for more than 1e7 points.
TriangleSurface groundOf(Grid const& grid, Units const& units, MapArea const& area, double step,
                         Outside outside);
} // namespace asperity::geometry
