#pragma once

#include "base/Types.hpp"
#include "fem/FaultSurface.hpp"
#include "friction/Types.hpp"

#include <vector>

namespace asperity::dynamics
{
enum class Norm
{
  root_mean_square, // over the fault
  maximum
};

// Tangential components of v (owned dofs) at the nodes: blocks(num_nodes, T).
void gather(fem::FaultSurface const& surface, Vector const& v, friction::BlockView const& blocks);

// What friction sees, w = v_t + Vp / slip factor with the plate rate Vp of back slip:
// blocks(num_nodes, T). The slip rate as a vector is slip factor times w.
void gatherSlip(fem::FaultSurface const& surface, Vector const& v,
                friction::BlockView const& blocks);
// The same on the host, node by node: (num_nodes, T).
std::vector<double> slipUnknowns(fem::FaultSurface const& surface, Vector const& v);

// Sets v(owned dofs) to -Vp / slip factor where friction decides on the velocity, so that a fault
// that moves with it does not slip.
void stickToPlates(fem::FaultSurface const& surface, Vector& v);

// Slip rates V(num_nodes) = slip factor |w| of w(num_nodes, T), see gatherSlip.
void slipRate(fem::FaultSurface const& surface, friction::ConstBlockView const& v,
              friction::NodeView const& V);

// The largest slip rate over all ranks, at nodes that slide. Collective.
double peakSlipRate(fem::FaultSurface const& surface, Vector const& v);

// Of values a and b at the nodes, over all ranks; not finite where one of them is not. Collective.
double distance(fem::FaultSurface const& surface, friction::ConstNodeView const& a,
                friction::ConstNodeView const& b, Norm norm = Norm::root_mean_square);

// Friction knows the direction of slip only where a node is free or does not slip in each
// component: InputError unless the prescribed velocity (owned dofs, `components` for each vertex)
// and the plate rate add up to no slip at held components beside free ones. t [s] for the message.
void requireRestBesideSliding(fem::FaultSurface const& surface, Vector const& prescribed_velocity,
                              int components, double t);
} // namespace asperity::dynamics
