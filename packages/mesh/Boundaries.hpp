#pragma once

#include "mesh/GlobalMesh.hpp"
#include "mesh/NamedCondition.hpp"

namespace asperity::mesh
{
// Assigns every facet of the outer boundary to the last boundary whose condition holds at its
// centroid, whether it had a name before or not; facets where none holds keep their boundary.
// Facets of faults inside the body do not belong to the outer boundary, whether the mesh is split
// or not. Boundaries of the mesh that lose all their facets are dropped. Throws an InputError,
// whose message starts with `where`, if a condition gives a name to no facet or has the name of a
// fault.
template <int Dim>
void overrideBoundaries(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
                        std::string const& where = "Mesh / Boundaries");

// The same for the parts of a mesh: the result is this rank's part of what the function above makes
// of the whole mesh. Names, and an InputError, are the same on every rank. Collective.
template <int Dim>
void overrideBoundaries(Mesh<Dim>& part, std::vector<NamedCondition<Dim>> const& conditions,
                        Communicator const& communicator,
                        std::string const& where = "Mesh / Boundaries");

// Returns the name of a boundary with the facets of all these boundaries: the given name if there
// is only one, otherwise a new boundary, which is added to the mesh.
template <int Dim>
std::string joinBoundaries(Mesh<Dim>& part, std::vector<std::string> const& names);
} // namespace asperity::mesh
