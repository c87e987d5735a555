#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::geometry
{
// Divides edges inside the volume, of cells with dihedral angles below `wanted` [degrees], by a new
// vertex at the place that makes the smallest angle of the cells around the edge largest, if that
// is larger than before. A flat cell whose vertices all lie on one surface is repaired by that: the
// new vertex is free to leave the surface. Returns the number of new vertices.
int divideEdges(GlobalMesh<3>& mesh, double wanted);
} // namespace asperity::geometry
