#include "dynamics/InitialState.hpp"

#include "base/Errors.hpp"
#include "friction/Registry.hpp"

#include <Tpetra_CrsMatrix.hpp>

namespace asperity::dynamics
{
RCP<Vector> staticDisplacement(Body const& body, RateSolverSettings const& settings,
                               Vector const& load)
{
  Vector b(load, Teuchos::Copy);
  body.clearFixed(b);
  auto u = body.vector();
  solveLinear(fem::combine(body.matrices, 0, 0, 1, body.fixed), body, settings, b, *u);
  return u;
}

namespace
{
// Where the fault moves, friction is a known force; where it rests, only cohesion can hold it.
struct RestingFault
{
  Fault fault;
  friction::BlockView force; // at the moving nodes
};

RestingFault restingFault(Fault const& fault, std::string const& law, Vector const& v,
                          friction::ConstNodeView const& alpha)
{
  const int size = fault.numNodes();
  const int tangents = fault.num_tangents;
  friction::BlockView blocks("asperity::dynamics::v", size, tangents);
  friction::BlockView gradient("asperity::dynamics::gradient", size, tangents);
  friction::HessianView hessian("asperity::dynamics::hessian", size, tangents, tangents);
  friction::FlagView kinked("asperity::dynamics::kinked", size);
  fault.gather(v, blocks);
  fault.friction->linearise(blocks, alpha, gradient, hessian, kinked);

  friction::NodeView none("asperity::dynamics::noStress", size);
  friction::NodeView cohesion("asperity::dynamics::cohesionAtRest", size);
  auto const given = fault.data.cohesion;
  Kokkos::parallel_for(
    "asperity::dynamics::restingFault", Kokkos::RangePolicy<friction::ExecutionSpace>(0, size),
    KOKKOS_LAMBDA(int node) {
      bool moving = false;
      for (int k = 0; k < tangents; ++k) {
        moving = moving || blocks(node, k) != 0;
      }
      cohesion(node) = moving ? 0 : given(node);
      for (int k = 0; k < tangents; ++k) {
        gradient(node, k) = moving ? gradient(node, k) : 0;
      }
    });
  RestingFault result{{}, gradient};
  result.fault.dofs = fault.dofs;
  result.fault.fixed = fault.fixed;
  result.fault.num_tangents = tangents;
  result.fault.slip_factor = fault.slip_factor;
  result.fault.data = fault.data;
  result.fault.data.sigma_n = none;
  result.fault.data.cohesion = cohesion;
  result.fault.communicator = fault.communicator;
  result.fault.friction = friction::makeFrictionKernels(law, result.fault.data);
  return result;
}
} // namespace

RCP<Vector> initialAcceleration(Body const& body, Fault const& fault,
                                RateSolverSettings const& settings, std::string const& law,
                                Vector const& load, Vector const& prescribed, Vector const& u,
                                Vector const& v, friction::ConstNodeView const& alpha)
{
  auto const resting = restingFault(fault, law, v, alpha);
  auto b = body.vector();
  body.residual(load, u, v, prescribed, *b);
  {
    auto const force = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), resting.force);
    auto const values = b->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (int node = 0; node < fault.numNodes(); ++node) {
      for (int k = 0; k < fault.num_tangents; ++k) {
        values(fault.dofs[node][k], 0) -= force(node, k);
      }
    }
  }
  body.clearFixed(*b);
  // The rounding of l - K u, which may be large forces in balance, would set a body at rest in
  // motion.
  auto const scale = std::max(load.normInf(), 1e-300);
  auto a = body.vector();
  if (b->normInf() > 1e-12 * scale) {
    RateSolverSettings mass_settings = settings;
    mass_settings.tnnmg.absolute_tolerance = 0;
    mass_settings.tnnmg.relative_tolerance = 1e-12;
    auto const solver = makeRateSolver(fem::combine(body.matrices, 1, 0, 0, body.fixed), body,
                                       resting.fault, mass_settings);
    solver->begin(*b, *a);
    auto const result = solver->solve({*resting.fault.friction, alpha});
    if (!result.converged) {
      throw SolveError("The initial acceleration was not found: TNNMG did not converge on the "
                       "balance of momentum.");
    }
    solver->velocity(*a);
  }
  a->update(1, prescribed, 1);
  return a;
}
} // namespace asperity::dynamics
