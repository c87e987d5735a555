#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::geometry
{
// Divides edges inside the volume, of cells with dihedral angles below `wanted` [degrees]. The new
// vertex lies where the smallest angle of the cells around the edge is largest; the edge stays
// undivided if that angle does not increase. This repairs flat cells whose vertices all lie on one
// surface, since the new vertex need not lie on it. Returns the number of new vertices.
int divideEdges(GlobalMesh<3>& mesh, double wanted);
} // namespace asperity::geometry
