#pragma once

#include "mesh/GlobalMesh.hpp"
#include "mesh/NamedCondition.hpp"

namespace asperity::mesh
{
// Assigns every cell to the last region whose condition holds at its centroid; cells where none
// holds stay where they are. Regions of the mesh that lose all their cells are dropped. InputError,
// starting with `where`, if a region named here gets no cell.
template <int Dim>
void overrideRegions(GlobalMesh<Dim>& mesh, std::vector<NamedCondition<Dim>> const& conditions,
                     std::string const& where = "Mesh / Regions");

// The same for the parts of a mesh: gives the part of the mesh that the function above makes of the
// whole, with the same names on every rank, or the same InputError. Collective.
template <int Dim>
void overrideRegions(Mesh<Dim>& part, std::vector<NamedCondition<Dim>> const& conditions,
                     Communicator const& communicator, std::string const& where = "Mesh / Regions");
} // namespace asperity::mesh
