#pragma once

#include "mesh/GlobalMesh.hpp"
#include "mesh/NamedCondition.hpp"

namespace asperity::mesh
{
// Gives every facet of the outer boundary to the last boundary whose condition holds at its
// centroid, whether it had a name before or not; facets where none holds stay where they are.
// Boundaries of the mesh that lose all their facets are dropped. InputError, starting with `where`,
// if a condition gives a name to no facet.
template <int Dim>
void overrideBoundaries(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
                        std::string const& where = "Mesh / Boundaries");

// The same for the parts of a mesh: gives the part of the mesh that the function above makes of the
// whole, with the same names on every rank, or the same InputError. Collective.
template <int Dim>
void overrideBoundaries(Mesh<Dim>& part, std::vector<NamedCondition<Dim>> const& conditions,
                        Communicator const& communicator,
                        std::string const& where = "Mesh / Boundaries");
} // namespace asperity::mesh
