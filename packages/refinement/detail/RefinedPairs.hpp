#pragma once

#include "refinement/detail/FaultEdges.hpp"
#include "refinement/detail/Points.hpp"

namespace asperity::refinement::detail
{
// All pairs, by points in place of vertices, of which a point is in `needed` (points of this rank's
// part), each once, those of the coarse part first. Their points join `needed`; those that only
// other ranks have join `points`. Collective.
template <int Dim>
std::vector<SplitVertex> pairsOf(std::vector<char>& needed, Mesh<Dim> const& coarse,
                                 FaultEdges<Dim> const& faults, Points<Dim>& points,
                                 Communicator const& communicator);
} // namespace asperity::refinement::detail
