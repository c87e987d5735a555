#pragma once

#include "dynamics/Body.hpp"
#include "fem/FaultSurface.hpp"

#include <vector>

namespace asperity::dynamics
{
// The pressure of a rigid foundation at the nodes of a fault [Pa] in the static state u, positive
// in compression: the reaction K u - load across the fault per weight of what bears it.
// support(num_nodes): these weights, see fem::supportWeights. u and load live on the owned dofs.
std::vector<double> foundationPressure(Body const& body, fem::NodalFrames const& frames,
                                       fem::FaultSurface const& surface,
                                       std::vector<double> const& support, Vector const& load,
                                       Vector const& u);
} // namespace asperity::dynamics
