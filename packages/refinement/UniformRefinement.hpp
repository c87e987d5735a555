#pragma once

#include "mesh/Mesh.hpp"

namespace asperity::refinement
{
// Divides every cell of a mesh `refinements` times, triangles into 4 and tetrahedra into 8, each
// rank its own part: no rank ever has the whole. The vertices are the coarse ones and midpoints of
// edges, so that a boundary stays where the facets of the coarse mesh are. Children have the region
// of their cell and the boundary or fault of their facet.
//
// Tetrahedra are divided by Bey's rule (detail/RedRule.hpp): however often, their descendants have
// at most three shapes. Cells, coordinates and global ids do not depend on the number of ranks;
// coarse vertices keep their ids. The part is as Mesh says, each rank with its vertices, ghosts and
// all cells that touch its vertices, in no particular order.
//
// InputError on every rank, which starts with `where`, for less than zero refinements, if
// requireMemory refuses, or if a vertex at a fault would need three copies. Collective.
template <int Dim>
Mesh<Dim> refineUniformly(Mesh<Dim> part, int refinements, Communicator const& communicator,
                          std::string const& where = "Mesh / Refinements");
} // namespace asperity::refinement
