#pragma once

#include "dynamics/Body.hpp"
#include "fem/FaultSurface.hpp"

#include <vector>

namespace asperity::dynamics
{
// The normal stress at the nodes of a fault [Pa], (num_nodes), in the static state u under a load,
// positive in compression: the reaction K u - load across the fault divided by support(num_nodes),
// see fem::supportWeights. u and load live on the owned dofs. Unlike NormalReaction::compression it
// has a value where the fault does not slide, too.
std::vector<double> staticNormalStress(Body const& body, fem::NodalFrames const& frames,
                                       fem::FaultSurface const& surface,
                                       std::vector<double> const& support, Vector const& load,
                                       Vector const& u);
} // namespace asperity::dynamics
