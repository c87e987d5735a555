#pragma once

#include "mesh/Mesh.hpp"

namespace asperity::refinement
{
// Throws an InputError on every rank, which starts with `where`, unless a mesh that is refined so
// often can be counted and held: a rank numbers its cells with int, global numbers of degrees of
// freedom are of type GlobalOrdinal, and the ranks of a node share its physical memory, of which
// the mesh alone takes some bytes per cell (bytes_per_cell, measured). Collective.
template <int Dim>
void requireRoom(Mesh<Dim> const& part, int refinements, Communicator const& communicator,
                 std::string const& where);

// Measured on large meshes of tetrahedra, at the highest point of the last refinement
// (log/performance.md).
constexpr double bytes_per_cell = 40;
} // namespace asperity::refinement
