#pragma once

#include "mesh/GlobalMesh.hpp"
#include "mesh/NamedCondition.hpp"

namespace asperity::mesh
{
// Assigns a facet inside the body to the last fault whose condition holds at all its vertices and
// at its centroid; facets where none holds keep their fault, if they have one. To be called before
// splitFaults. Faults of the mesh that lose all their facets are dropped. Throws an InputError,
// whose message starts with `where`, if a fault named here gets no facet or has the name of a
// boundary on the surface.
template <int Dim>
void addFaults(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
               std::string const& where = "Mesh / Faults");
} // namespace asperity::mesh
