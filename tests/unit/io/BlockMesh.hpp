#pragma once

#include "mesh/Mesh.hpp"

#include <functional>

namespace asperity::test
{
inline constexpr int block_nx = 4, block_nz = 3;

using Placement = std::function<Point<3>(Point<3> const&)>;
inline Point<3> inPlace(Point<3> const& x) { return x; }

// Unit bricks 0 <= x <= 4, 0 <= y <= 1, 0 <= z <= 3, each cut into tetrahedra, its vertices moved
// by `placement`, which keeps orientation. The boundary `base` is y = 0; if `periodic`, z = 0 and
// z = 3 are one. Global ids run against the coordinates, and the ranks own the vertices by turns.
Mesh<3> blockMesh(bool periodic = false, Placement const& placement = inPlace);

// A tetrahedron of volume 4, all of it on rank 0. The boundary `base` is its side z = 0, of area 3.
Mesh<3> tetrahedron();
} // namespace asperity::test
