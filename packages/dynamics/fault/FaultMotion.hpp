#pragma once

#include "base/Types.hpp"
#include "dynamics/fault/Norm.hpp"
#include "fem/FaultSurface.hpp"
#include "portability/Renamed.hpp"
#include "portability/Views.hpp"

#include <vector>

namespace asperity::dynamics
{
// Tangential components of v (owned dofs) at the nodes: blocks(num_nodes, T).
void gather(fem::FaultSurface const& surface, Vector const& v, BlockView const& blocks);

// The largest component of Vp / slip factor at a node, from the plate rates(num_nodes T) [m/s].
KOKKOS_INLINE_FUNCTION double motionOfPlates(ConstNodeView const& rates, int node, int size,
                                             double factor)
{
  double largest = 0;
  for (int k = 0; k < size; ++k) {
    const double rate = math::fabs(rates(node * size + k)) / factor;
    largest = rate > largest ? rate : largest;
  }
  return largest;
}

// The velocity w = v_t + Vp / slip factor that friction depends on, with the plate rate Vp of back
// slip: blocks(num_nodes, T). The slip rate as a vector is slip factor times w. A locked fault
// slips at rates that get lost in the rounding of v: w is zero where it is less than 8 units of
// rounding of the motion of the plates.
void gatherSlip(fem::FaultSurface const& surface, Vector const& v, BlockView const& blocks);
// The slip as gatherSlip gathers its rate, from the displacement u(owned dofs) after `time` [s] in
// which the plates have moved, since start(num_nodes, T): slip factor times blocks(num_nodes, T) is
// slip as a vector.
void gatherSlipSince(fem::FaultSurface const& surface, ConstBlockView const& start, Vector const& u,
                     double time, BlockView const& blocks);

// Sets the unknowns v(owned dofs) where friction decides on the velocity such that the fault slips
// at these rates(num_nodes, T) [m/s].
void setSlipRate(fem::FaultSurface const& surface, std::vector<double> const& rates, Vector& v);

// Sets v(owned dofs) to -Vp / slip factor where friction decides on the velocity: there a fault
// that moves at v does not slip. Does nothing without a plate rate.
void setZeroSlipRate(fem::FaultSurface const& surface, Vector& v);

// Slip rates V(num_nodes) = slip factor |w|, where v holds the w(num_nodes, T) of gatherSlip. Runs
// on the device.
void slipRate(fem::FaultSurface const& surface, ConstBlockView const& v, NodeView const& V);

// The largest of values(num_nodes) on this rank, at least 0: of all, or where flags(num_nodes) are
// set.
double largestOf(ConstNodeView const& values);
double largestWhere(ConstFlagView const& flags, ConstNodeView const& values);

// The largest of the slip rates V(num_nodes) [m/s] over all ranks, at nodes that count
// (fem::FaultSurface::counts). Collective.
double peakSlipRate(fem::FaultSurface const& surface, ConstNodeView const& V);

// The norm of a - b over the nodes of all ranks; not finite if one of the values is not finite.
// Collective.
double distance(fem::FaultSurface const& surface, ConstNodeView const& a, ConstNodeView const& b,
                Norm norm = Norm::root_mean_square);

// The velocity w, as of gatherSlip, that is prescribed in held tangential components beside free
// ones, with prescribed_velocity(owned dofs): blocks(num_nodes, T), zero elsewhere. Friction at
// such a node depends on it, too (friction::StateAndStress::prescribed). Returns whether this rank
// has any.
bool gatherPrescribedPart(fem::FaultSurface const& surface, Vector const& prescribed_velocity,
                          BlockView const& blocks);
} // namespace asperity::dynamics
