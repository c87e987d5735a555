#pragma once

#include "mesh/detail/FacetTable.hpp"

namespace asperity::mesh::detail
{
// The names, sorted, of the boundaries whose facets lie inside the body, between two cells each:
// faults before the split. InputError, which starts with `where`, for a boundary with facets inside
// and others on the surface.
template <int Dim>
std::vector<std::string> innerBoundaries(GlobalMesh<Dim> const& mesh, std::string const& where);
template <int Dim>
std::vector<std::string> innerBoundaries(GlobalMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                                         std::string const& where);
} // namespace asperity::mesh::detail
