#pragma once

#include "mesh/detail/FacetTable.hpp"

namespace asperity::mesh::detail
{
// Throws an InputError that starts with `where` unless the pairs of a mesh that is split, and the
// facets of its faults, are as Mesh describes them. Vertex numbers of cells and facets are in
// range.
template <int Dim>
void checkSplits(GlobalMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                 std::string const& where);
} // namespace asperity::mesh::detail
