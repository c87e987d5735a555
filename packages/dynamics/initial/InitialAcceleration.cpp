#include "dynamics/initial/InitialAcceleration.hpp"

#include "base/Errors.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "dynamics/rate/OpeningProblem.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>
#include <sstream>

namespace asperity::dynamics
{
RCP<Vector> prescribedAcceleration(Body const& body, double dt)
{
  auto result = body.vector();
  auto const at_zero = body.vector();
  body.prescribed_velocity(dt, *result);
  body.prescribed_velocity(0, *at_zero);
  result->update(-1 / dt, *at_zero, 1 / dt);
  return result;
}

namespace
{
// Where the fault moves, friction is a known force; where it rests, cohesion can hold it, and the
// friction of a law that bears shear stress at rest.
struct ForcesAtStart
{
  BlockView force;   // at the moving nodes
  NodeView strength; // at the resting ones [Pa]
};

ForcesAtStart forcesAtStart(Fault const& fault, Vector const& v, friction::StateAndStress const& at)
{
  auto const& surface = fault.surface();
  const int size = surface.numNodes();
  const int tangents = surface.numTangents();
  BlockView blocks("asperity::dynamics::v", size, tangents);
  BlockView gradient("asperity::dynamics::gradient", size, tangents);
  HessianView hessian("asperity::dynamics::hessian", size, tangents, tangents);
  FlagView kinked("asperity::dynamics::kinked", size);
  gatherSlip(surface, v, blocks);
  fault.friction().linearise(blocks, at, gradient, hessian, kinked);

  const NodeView strength("asperity::dynamics::strengthAtRest", size);
  const NodeView mu("asperity::dynamics::mu", size);
  const BlockView at_rest("asperity::dynamics::atRest", size, tangents);
  fault.friction().coefficient(at_rest, at.alpha, mu);
  auto const cohesion = fault.laws().cohesion;
  auto const sigma_n = at.sigma_n;
  Kokkos::parallel_for(
    "asperity::dynamics::forcesAtStart", RangePolicy(0, size), KOKKOS_LAMBDA(int node) {
      bool moving = false;
      for (int k = 0; k < tangents; ++k) {
        moving = moving || blocks(node, k) != 0;
      }
      strength(node) = moving ? 0 : cohesion(node) + sigma_n(node) * mu(node);
      for (int k = 0; k < tangents; ++k) {
        gradient(node, k) = moving ? gradient(node, k) : 0;
      }
    });
  return {gradient, strength};
}

// b -= force at the tangential dofs of the fault.
void subtractAtFault(fem::FaultSurface const& surface, ConstBlockView const& force, Vector& b)
{
  auto const host = toHost(force);
  auto const values = b.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (int node = 0; node < surface.numNodes(); ++node) {
    for (int k = 0; k < surface.numTangents(); ++k) {
      values(surface[node].dofs[k], 0) -= host(node, k);
    }
  }
}

// Whether b is more than what rounding leaves of l - K u, which may be the difference of large
// forces: that must not accelerate a body at rest.
bool exceedsRounding(Vector const& b, Vector const& load)
{
  constexpr double rounding = 1e-12;
  constexpr double least_load = 1e-300; // so that without a load any b counts
  return b.normInf() > rounding * std::max(load.normInf(), least_load);
}

// The minimiser a of 1/2 <M a, a> - <b, a> + sum of weight strength |a| over the fault's nodes.
RCP<Vector> accelerationUnder(Vector const& b, Body const& body, Fault const& fault,
                              ConstNodeView const& strength, ConstNodeView const& alpha,
                              RateSolverSettings settings)
{
  auto const& surface = fault.surface();
  settings.tnnmg.absolute_tolerance = 0;
  settings.tnnmg.relative_tolerance = 1e-12;
  auto const solver = makeRateSolver(fem::combine(body.matrices, fem::massWeights(), body.held),
                                     body, surface, settings);
  auto a = body.vector();
  solver->begin(b, *a);
  auto const kernels = fault.frictionWith(strength);
  const NodeView no_stress("asperity::dynamics::noStress", surface.numNodes());
  const FrictionProblem friction = {*kernels, {alpha, no_stress}};
  const OpeningProblem::Memory memory(surface.numNodes(), surface.numTangents());
  auto const result = surface.mayOpen()
                        ? solver->solve(OpeningProblem(friction, shut(surface.numNodes()), memory))
                        : solver->solve(friction);
  if (!result.converged) {
    std::ostringstream message;
    message << "The initial acceleration was not found: TNNMG did not converge on the balance of "
               "momentum, whose largest force is "
            << b.normInf() << " N. Try a larger 'TNNMG / Maximum Iterations'.";
    throw SolveError(message.str());
  }
  solver->velocity(*a);
  return a;
}
} // namespace

RCP<Vector> initialAcceleration(Body const& body, Fault const& fault,
                                RateSolverSettings const& settings, Vector const& load,
                                Motion const& start, friction::StateAndStress const& at)
{
  auto const forces = forcesAtStart(fault, start.v, at);
  auto b = body.vector();
  body.residual(load, start, *b);
  subtractAtFault(fault.surface(), forces.force, *b);
  body.clearHeld(*b);
  auto const a = exceedsRounding(*b, load)
                   ? accelerationUnder(*b, body, fault, forces.strength, at.alpha, settings)
                   : body.vector();
  a->update(1, start.a, 1);
  return a;
}
} // namespace asperity::dynamics
