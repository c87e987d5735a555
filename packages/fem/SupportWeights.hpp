#pragma once

#include "fem/FaultSurface.hpp"
#include "fem/constraints/VelocityCondition.hpp"

#include <vector>

namespace asperity::fem
{
// What the reaction across the fault is spread over at each of its nodes [m, in three dimensions
// m^2]: the node's share of the fault, and of the walls and continuations that go on in the fault's
// plane there. InputError where a node that slides is also held by a wall at another angle: the
// share of the fault in its reaction is not known there.
template <int Dim>
std::vector<double> supportWeights(Mesh<Dim> const& mesh, FaultSurface const& fault,
                                   std::vector<VelocityCondition<Dim>> const& conditions);
} // namespace asperity::fem
