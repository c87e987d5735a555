#pragma once

#include "mesh/NamedCondition.hpp"
#include "mesh/detail/FacetTable.hpp"

// Faults inside the body before the mesh is split along them: boundaries whose facets have two
// cells.
namespace asperity::mesh
{
// The names, sorted, of the boundaries whose facets lie inside the body, between two cells each:
// faults before the split. InputError, which starts with `where`, for a boundary with facets inside
// and others on the surface.
template <int Dim>
std::vector<std::string> innerBoundaries(GlobalMesh<Dim> const& mesh, std::string const& where);
template <int Dim>
std::vector<std::string> innerBoundaries(GlobalMesh<Dim> const& mesh,
                                         detail::FacetTable<Dim> const& table,
                                         std::string const& where);

// Assigns a facet inside the body to the last fault whose condition holds at all its vertices and
// at its centroid; facets where none holds keep their fault, if they have one. To be called before
// splitFaults. Faults of the mesh that lose all their facets are dropped. Throws an InputError,
// whose message starts with `where`, if a fault named here gets no facet or has the name of a
// boundary on the surface.
template <int Dim>
void addFaults(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
               std::string const& where = "Mesh / Faults");
} // namespace asperity::mesh
