#pragma once

#include "mesh/Mesh.hpp"
#include "mesh/detail/FacetTable.hpp"

#include <string>

namespace asperity::mesh::detail
{
// Throws an InputError that starts with `where` if facets of two cells lie on each other without
// being one facet: a vertex hangs inside an edge or a face of a cell, or a face is divided
// differently on its two sides. There the body would open like a crack.
//
// Facets with a vertex in common are compared at that vertex, for which a rank has all cells: the
// work is proportional to the boundary, and needs no other rank. As long as no two vertices lie at
// one place this finds every hanging vertex, since the facets on both sides of a gap begin at a
// vertex of both. Facets whose corners lie at the same places are the two sides of a fault, or of a
// crack that the mesh is meant to have, and are accepted.
template <template <int> class AnyMesh, int Dim>
void requireConforming(AnyMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                       std::string const& where);
} // namespace asperity::mesh::detail
