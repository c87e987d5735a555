#pragma once

#include "mesh/GlobalMesh.hpp"
#include "mesh/NamedCondition.hpp"

namespace asperity::mesh
{
// Assigns every cell to the last region whose condition holds at its centroid; cells where none
// holds keep their region. Regions of the mesh that lose all their cells are dropped. Throws an
// InputError, whose message starts with `where`, if a region named here gets no cell.
template <int Dim>
void overrideRegions(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
                     std::string const& where = "Mesh / Regions");

// The same for the parts of a mesh: the result is this rank's part of what the function above makes
// of the whole mesh. Names, and an InputError, are the same on every rank. Collective.
template <int Dim>
void overrideRegions(Mesh<Dim>& part, std::vector<NamedCondition<Dim>> const& conditions,
                     Communicator const& communicator, std::string const& where = "Mesh / Regions");
} // namespace asperity::mesh
