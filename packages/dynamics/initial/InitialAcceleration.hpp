#pragma once

#include "dynamics/fault/Fault.hpp"
#include "dynamics/rate/RateSolver.hpp"

namespace asperity::dynamics
{
// The prescribed acceleration at t = 0, as a difference quotient over dt [s], which is small
// compared with all steps; zero at dofs that are not held.
RCP<Vector> prescribedAcceleration(Body const& body, double dt);

// The acceleration that balances momentum at a given motion, state and normal stress: a minimises
//   1/2 <M a, a> - <l - C v - K u - f(v, alpha), a> + sum over nodes at rest of weight strength |a|
// over all a with the prescribed acceleration, start.a; a node at rest stays at rest if its
// strength, cohesion + sigma_n mu(0, alpha), can hold it. Throws SolveError if a is not found.
RCP<Vector> initialAcceleration(Body const& body, Fault const& fault,
                                RateSolverSettings const& settings, Vector const& load,
                                Motion const& start, friction::StateAndStress const& at);
} // namespace asperity::dynamics
