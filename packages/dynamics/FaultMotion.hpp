#pragma once

#include "base/Types.hpp"
#include "fem/FaultSurface.hpp"
#include "friction/Types.hpp"

namespace asperity::dynamics
{
enum class Norm
{
  root_mean_square, // over the fault
  maximum
};

// Tangential components of v (owned dofs) at the nodes: blocks(num_nodes, T).
void gather(fem::FaultSurface const& surface, Vector const& v, friction::BlockView const& blocks);

// Slip rates V(num_nodes) = slip factor |v| of tangential velocities v(num_nodes, T).
void slipRate(fem::FaultSurface const& surface, friction::ConstBlockView const& v,
              friction::NodeView const& V);

// The largest slip rate over all ranks, at nodes that slide. Collective.
double peakSlipRate(fem::FaultSurface const& surface, Vector const& v);

// Of values a and b at the nodes, over all ranks; not finite where one of them is not. Collective.
double distance(fem::FaultSurface const& surface, friction::ConstNodeView const& a,
                friction::ConstNodeView const& b, Norm norm = Norm::root_mean_square);

// Friction knows the direction of slip only where a node is free or at rest in each component:
// InputError unless the prescribed velocity (owned dofs, `components` for each vertex) is zero at
// held components beside free ones. t [s] for the message.
void requireRestBesideSliding(fem::FaultSurface const& surface, Vector const& prescribed_velocity,
                              int components, double t);
} // namespace asperity::dynamics
