#pragma once

#include "portability/Views.hpp"

namespace asperity::bench
{
// The kernels of asperity-bench itself.

// a = b + 3 c (McCalpin 1995)
void addTriad(NodeView const& a, NodeView const& b, NodeView const& c);

// Adds to r(num_nodes, T) the force that moves nodes with this curvature(num_nodes) at the speed v,
// along their first tangent.
void addForce(ConstNodeView const& curvature, double v, BlockView const& r);
} // namespace asperity::bench
