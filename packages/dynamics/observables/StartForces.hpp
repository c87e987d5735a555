#pragma once

#include "dynamics/Body.hpp"
#include "fem/FaultSurface.hpp"

namespace asperity::dynamics
{
// The forces at the start of a run, on the owned dofs [N per unit of thickness]: the loads l, what
// the motion resists with, and f, friction on the fault and the reactions at held dofs.
struct StartForces
{
  Vector const& load;
  BodyForces const& resisting;
  Vector const& force;
};

// r0 = l - M a - C v - K u - f, zero at held dofs.
RCP<Vector> residualAtStart(Body const& body, StartForces const& forces);

// How far a quasi-dynamic body is out of balance, the larger one of
//   on the fault      |r0| / max(|f|, |r0|)
//   inside the body   |r0| / max(|l|, |K u|, |C v|), these three everywhere
// in Euclidean norms over unknowns that are not held. fault_dofs: those of the fault, without held
// ones. Collective.
double startImbalance(Body const& body, IndexView const& fault_dofs, StartForces const& forces,
                      Vector const& r0);

// The part of the fault's sliding area, in [0, 1], where friction acts in the direction of the
// forces that drive the fault, l - C v - K u, by more than a hundredth of its size, rather than
// against them. Collective.
double startContradiction(Body const& body, fem::FaultSurface const& surface,
                          StartForces const& forces);
} // namespace asperity::dynamics
