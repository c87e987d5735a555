#include "dynamics/initial/InitialState.hpp"

#include "base/Errors.hpp"
#include "dynamics/coupling/SharedMultigrid.hpp"
#include "dynamics/fault/FaultMotion.hpp"
#include "tnnmg/direct/SchurComplement.hpp"

#include <Tpetra_CrsMatrix.hpp>

#include <algorithm>
#include <sstream>

namespace asperity::dynamics
{
namespace
{
// With rounding even a singular matrix may have a factor; then u is not a solution.
void requireSolution(CrsMatrix const& K, Vector const& b, Vector const& u)
{
  Vector rest(b, Teuchos::Copy);
  K.apply(u, rest, Teuchos::NO_TRANS, -1, 1);
  if (!(rest.norm2() <= 1e-6 * b.norm2())) {
    throw SolveError("The static problem has no solution: some part of the body can move without "
                     "resistance, or its numbers are too large to compute with. Check that the "
                     "boundary conditions hold it, that the moduli, viscosities and density in "
                     "Bulk are in SI units, and that Poisson's Ratio is not close to 0.5.");
  }
}

// K u = b until the residual is at most 1e-12 |b|.
void solveByMultigrid(RCP<const CrsMatrix> const& K, Body const& body,
                      Teuchos::ParameterList const& parameters, Vector const& b, Vector& u)
{
  const Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> none(
    "asperity::dynamics::none", 0, 1);
  Teuchos::ParameterList list(parameters);
  list.set("Method", "CG");      // a few cycles would not meet the tolerance
  list.set("Hierarchy", "Keep"); // without friction there are no Hessians
  tnnmg::MultigridCorrection multigrid(
    multigridProblem(K, body, {none, body.held.flagsOnDevice(), {}}), list);
  auto const result = multigrid.solve({}, b, 1e-12, u);
  if (!result.converged) {
    std::ostringstream message;
    message << "The static problem was not solved: conjugate gradients stopped after "
            << result.iterations
            << " iterations. Check that the boundary conditions hold the body, "
            << "and raise the iteration limit in TNNMG / MueLu Correction.";
    throw SolveError(message.str());
  }
}
} // namespace

RCP<Vector> staticDisplacement(Body const& body, RateSolverSettings const& settings,
                               Vector const& load)
{
  Vector b(load, Teuchos::Copy);
  body.clearHeld(b);
  auto const K = fem::combine(body.matrices, fem::ofElasticity(body.matrices), body.held);
  auto u = body.vector();
  if (settings.correction == Correction::direct) {
    const tnnmg::SchurComplement factor(*K, {});
    factor.condense(b).expand(Vector(factor.map()), *u);
    requireSolution(*K, b, *u);
  } else {
    solveByMultigrid(K, body, settings.multigrid, b, *u);
  }
  return u;
}

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
} // namespace

RCP<Vector> initialAcceleration(Body const& body, Fault const& fault,
                                RateSolverSettings const& settings, Vector const& load,
                                Motion const& start, friction::StateAndStress const& at)
{
  auto const& surface = fault.surface();
  auto const forces = forcesAtStart(fault, start.v, at);
  auto b = body.vector();
  body.residual(load, start, *b);
  {
    auto const force = toHost(forces.force);
    auto const values = b->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (int node = 0; node < surface.numNodes(); ++node) {
      for (int k = 0; k < surface.numTangents(); ++k) {
        values(surface[node].dofs[k], 0) -= force(node, k);
      }
    }
  }
  body.clearHeld(*b);
  // l - K u may be the difference of large forces. Its rounding must not accelerate a body at rest.
  auto const scale = std::max(load.normInf(), 1e-300);
  auto a = body.vector();
  if (b->normInf() > 1e-12 * scale) {
    RateSolverSettings mass_settings = settings;
    mass_settings.tnnmg.absolute_tolerance = 0;
    mass_settings.tnnmg.relative_tolerance = 1e-12;
    auto const solver = makeRateSolver(fem::combine(body.matrices, fem::ofMass(), body.held), body,
                                       surface, mass_settings);
    solver->begin(*b, *a);
    auto const kernels = fault.frictionWith(forces.strength);
    const NodeView no_stress("asperity::dynamics::noStress", surface.numNodes());
    auto const result = solver->solve({*kernels, {at.alpha, no_stress}});
    if (!result.converged) {
      std::ostringstream message;
      message << "The initial acceleration was not found: TNNMG did not converge on the balance of "
                 "momentum, whose largest force is "
              << b->normInf() << " N. Try a larger 'TNNMG / Maximum Iterations'.";
      throw SolveError(message.str());
    }
    solver->velocity(*a);
  }
  a->update(1, start.a, 1);
  return a;
}
} // namespace asperity::dynamics
