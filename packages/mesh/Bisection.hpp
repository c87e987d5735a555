#pragma once

#include "mesh/GlobalMesh.hpp"

#include <functional>

namespace asperity::mesh
{
using Triangle = std::array<Point<2>, 3>;

// The largest diameter (longest edge, in m) that is allowed for a cell with these corners, which
// may coincide; positive.
using SizeFunction = std::function<double(Triangle const&)>;

// Refines triangles by newest vertex bisection until none exceeds its allowed diameter, and no more
// than that and conformity ask for. The refinement edges of the given cells are their longest
// edges. Regions and boundaries are inherited. Angles stay away from zero: descendants have at most
// four shapes per cell given. Mitchell, ACM Trans. Math. Software 15 (1989), 326.
// InputError if that takes more than 10 million vertices; at once where an estimate is that high.
GlobalMesh<2> bisect(GlobalMesh<2> const& mesh, SizeFunction const& largest_diameter);

// The size of cells that is wanted at a point, in m; positive.
using CellSize = std::function<double(Point<2> const&)>;

// The diameter that a cell size allows a cell: sqrt(2) times the smallest one found at its corners,
// the midpoints of its edges and its centroid. The legs of a right isosceles triangle are then no
// longer than the size; they are exactly as long if the size is that of the first cells' legs
// divided by a power of two, and rounding does not count.
SizeFunction largestDiameter(CellSize const& size);
} // namespace asperity::mesh
