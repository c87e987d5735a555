#pragma once

#include "portability/Views.hpp"

// The kernels of asperity-bench itself.

// a = b + 3 c (McCalpin 1995)
void addTriad(asperity::NodeView const& a, asperity::NodeView const& b,
              asperity::NodeView const& c);

// Adds to r(num_nodes, T) the force that moves nodes with this curvature(num_nodes) at the speed v,
// along their first tangent.
void addForce(asperity::ConstNodeView const& curvature, double v, asperity::BlockView const& r);
