#pragma once

#include "fem/FaultSurface.hpp"
#include "fem/constraints/VelocityCondition.hpp"

#include <vector>

namespace asperity::fem
{
// The length (in three dimensions the area) over which the reaction across the fault is distributed
// at each of its nodes [m, m^2]: the node's share of the fault, and of the walls and continuations
// that continue the fault in its plane there. InputError where a wall that is neither in line with
// the fault nor perpendicular to it also holds a node that slides: the share of the fault in the
// reaction is unknown there.
template <int Dim>
std::vector<double> supportWeights(Mesh<Dim> const& mesh, FaultSurface const& fault,
                                   std::vector<VelocityCondition<Dim>> const& conditions);
} // namespace asperity::fem
