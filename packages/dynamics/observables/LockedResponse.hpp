#pragma once

#include "dynamics/State.hpp"
#include "dynamics/initial/StaticSolver.hpp"
#include "fem/FaultSurface.hpp"

namespace asperity::dynamics
{
// What flow and yielding have moved: the static displacement that they cause in the elastic body
// where the fault does not slip and what is held stays. In a quasi-static motion the rest of the
// displacement is the elastic response to slip, to the motion of boundaries and to loads.
class LockedResponse
{
public:
  // The fault at rest must hold the body. Collective.
  LockedResponse(Body const& body, fem::FaultSurface const& surface,
                 RateSolverSettings const& settings);

  // [m], on the owned dofs. Throw SolveError if they are not found. Collective.
  // To the flow of Maxwell branches: K u = sum of K_k (state.u - d_k).
  RCP<Vector> toFlow(State const& state);
  // To the inelastic strain of cells: K u = p.
  RCP<Vector> toInelasticStrain(State const& state);

private:
  Body locked_;
  StaticSolver solver_;
};

// The body whose fault neither slips nor opens. Collective.
Body lockedAt(fem::FaultSurface const& surface, Body body);
} // namespace asperity::dynamics
