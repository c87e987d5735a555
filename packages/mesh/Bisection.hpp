#pragma once

#include "mesh/GlobalMesh.hpp"

#include <functional>

namespace asperity::mesh
{
using Triangle = std::array<Point<2>, 3>;

// The largest diameter (longest edge, in m) that is allowed for a cell with these corners;
// positive.
using SizeFunction = std::function<double(Triangle const&)>;

// Refines triangles by newest vertex bisection until none exceeds its allowed diameter, and no more
// than that and conformity ask for. The refinement edges of the given cells are their longest
// edges. Regions and boundaries are inherited. Angles stay away from zero: descendants have at most
// four shapes per cell given. Mitchell, ACM Trans. Math. Software 15 (1989), 326.
GlobalMesh<2> bisect(GlobalMesh<2> const& mesh, SizeFunction const& largest_diameter);
} // namespace asperity::mesh
