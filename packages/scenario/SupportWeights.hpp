#pragma once

#include "fem/BoundaryNodes.hpp"
#include "fem/VelocityCondition.hpp"

#include <vector>

namespace asperity::scenario
{
// What the reaction across the fault is spread over at each of its nodes [m, in three dimensions
// m^2]: the node's share of the fault, and of the walls and continuations that go on in the fault's
// plane there. InputError where a node that slides is held by a wall at another angle, too: how
// much of its reaction is the fault's, nobody could say. slides: for each fault node.
template <int Dim>
std::vector<double> supportWeights(Mesh<Dim> const& mesh,
                                   fem::BoundaryNodes<Dim> const& fault_nodes,
                                   std::vector<fem::VelocityCondition<Dim>> const& conditions,
                                   std::string const& fault, std::vector<bool> const& slides);
} // namespace asperity::scenario
