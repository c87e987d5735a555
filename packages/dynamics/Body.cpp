#include "dynamics/Body.hpp"

#include "fem/MatrixProducts.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

namespace asperity::dynamics
{
void BodyForces::subtractFrom(Vector& b) const
{
  auto const inertia = inertial->getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const viscosity = viscous->getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const elasticity = elastic->getLocalViewDevice(Tpetra::Access::ReadOnly);
  auto const result = b.getLocalViewDevice(Tpetra::Access::ReadWrite);
  Kokkos::parallel_for(
    "asperity::dynamics::subtractForces",
    Kokkos::RangePolicy<ExecutionSpace>(0, result.extent_int(0)), KOKKOS_LAMBDA(int dof) {
      result(dof, 0) = result(dof, 0) - inertia(dof, 0) - viscosity(dof, 0) - elasticity(dof, 0);
    });
}

RCP<Vector> Body::vector() const { return rcp(new Vector(dofs->owned())); }

void Body::applyMass(Vector const& x, Vector& y, double alpha, double beta) const
{
  if (!matrices.is_massless) {
    matrices.mass->apply(x, y, Teuchos::NO_TRANS, alpha, beta);
  } else if (beta == 0) {
    y.putScalar(0);
  } else if (beta != 1) {
    y.scale(beta);
  }
}

BodyForces Body::noForces() const { return {vector(), vector(), vector()}; }

void Body::computeForces(Vector const& u, Vector const& v, Vector const& a, BodyForces& forces,
                         Vector* momentum) const
{
  std::vector<fem::MatrixProduct> products = {{*matrices.stiffness, u, *forces.elastic},
                                              {*matrices.viscosity, v, *forces.viscous}};
  const auto addMassTimes = [&](Vector const& x, Vector& y) {
    if (matrices.is_massless) {
      y.putScalar(0);
    } else {
      products.push_back({*matrices.mass, x, y});
    }
  };
  addMassTimes(a, *forces.inertial);
  if (momentum) {
    addMassTimes(v, *momentum);
  }
  fem::multiply(products);
}

void Body::residual(Vector const& l, Vector const& u, Vector const& v, Vector const& a,
                    Vector& result) const
{
  Tpetra::deep_copy(result, l);
  applyMass(a, result, -1, 1);
  matrices.viscosity->apply(v, result, Teuchos::NO_TRANS, -1, 1);
  matrices.stiffness->apply(u, result, Teuchos::NO_TRANS, -1, 1);
}

void Body::clearHeld(Vector& x) const
{
  auto const values = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  auto const rows = held.ownedOnDevice();
  Kokkos::parallel_for(
    "asperity::dynamics::clearHeld", Kokkos::RangePolicy<ExecutionSpace>(0, rows.extent_int(0)),
    KOKKOS_LAMBDA(int k) { values(rows(k), 0) = 0; });
}
} // namespace asperity::dynamics
