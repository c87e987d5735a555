#pragma once

#include "mesh/Mesh.hpp"
#include "mesh/detail/FacetTable.hpp"

#include <string>

namespace asperity::mesh::detail
{
// Throws an InputError that starts with `where` if facets of two cells overlap without being one
// facet: a vertex hangs inside an edge or a face of a cell, or a face is divided differently on its
// two sides. There the body would open like a crack.
//
// Facets that share a vertex are compared at that vertex, by a rank that has all its cells: the
// work is proportional to the boundary, and no communication is needed. Unless two vertices lie at
// one place, this finds every hanging vertex, since the facets on both sides of a gap share a
// vertex at its end. Facets whose corners lie at the same places are accepted: they are the two
// sides of a fault or of an intended crack.
template <template <int> class AnyMesh, int Dim>
void requireConforming(AnyMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                       std::string const& where);
} // namespace asperity::mesh::detail
