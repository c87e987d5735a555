#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::mesh
{
// A plane mesh extruded along z: every triangle becomes a prism between each two neighbouring
// levels (z in m, ascending, at least two), and every prism three tetrahedra. The diagonals of its
// sides start at the vertex with the smaller number on the lower level, so that all layers are
// alike. Vertex v on level k has the number k num_plane_vertices + v. Regions, boundaries and
// periods are inherited; `front` and `back` are the first and the last level. Throws InputError if
// the levels are not valid or a boundary has one of these two names already.
GlobalMesh<3> extrude(GlobalMesh<2> const& plane, std::vector<double> const& levels);

// 0, length / num_layers, ..., length
std::vector<double> equalLevels(double length, int num_layers);
} // namespace asperity::mesh
