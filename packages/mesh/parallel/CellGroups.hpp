#pragma once

#include "mesh/Mesh.hpp"

namespace asperity::mesh
{
// Completes groups of cells, each of which has one vertex in common: adds to the part of a rank
// the cells of other ranks that belong to a group of one of its cells. New cells stand behind those
// of the part, their vertices behind its ghosts, with all copies at faults. The part keeps its
// facets, which are those at its own vertices.
// group(num_cells): the local vertex of each cell's group, the same on every rank. Collective.
template <int Dim>
void completeGroups(Mesh<Dim>& mesh, std::vector<int> const& group,
                    Communicator const& communicator);
} // namespace asperity::mesh
