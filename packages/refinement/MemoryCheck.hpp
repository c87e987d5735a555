#pragma once

#include "mesh/Mesh.hpp"

namespace asperity::refinement
{
// Throws an InputError, which starts with `where`, on every rank unless a mesh that is refined this
// number of times can be numbered and stored: a rank numbers its cells with int, global numbers of
// degrees of freedom are of type GlobalOrdinal, and the ranks of a node share its physical memory,
// of which the mesh alone takes bytes_per_cell for each cell. Collective.
template <int Dim>
void requireMemory(Mesh<Dim> const& part, int refinements, Communicator const& communicator,
                   std::string const& where);

// Of large meshes of tetrahedra, at the peak of the last refinement.
constexpr double bytes_per_cell = 40;
} // namespace asperity::refinement
