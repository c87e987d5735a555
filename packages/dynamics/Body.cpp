#include "dynamics/Body.hpp"

#include "base/MatrixProducts.hpp"
#include "fem/inelastic/InelasticCells.hpp"

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
    "asperity::dynamics::subtractForces", RangePolicy(0, result.extent_int(0)),
    KOKKOS_LAMBDA(int dof) {
      result(dof, 0) = result(dof, 0) - inertia(dof, 0) - viscosity(dof, 0) - elasticity(dof, 0);
    });
}

RCP<Vector> Body::vector() const { return rcp(new Vector(dofs->owned())); }

std::vector<RCP<Vector>> Body::branchVectors() const
{
  std::vector<RCP<Vector>> vectors;
  for (std::size_t k = 0; k < matrices.branches.size(); ++k) {
    vectors.push_back(vector());
  }
  return vectors;
}

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

BodyForces Body::noForces() const
{
  return {vector(), vector(), vector(), branchVectors(), cells ? vector() : Teuchos::null};
}

void Body::computeForces(Motion const& motion, BodyForces& forces, Vector* momentum) const
{
  std::vector<MatrixProduct> products = {{*matrices.stiffness, motion.u, *forces.elastic},
                                         {*matrices.viscosity, motion.v, *forces.viscous}};
  const auto addMassTimes = [&](Vector const& x, Vector& y) {
    if (matrices.is_massless) {
      y.putScalar(0);
    } else {
      products.push_back({*matrices.mass, x, y});
    }
  };
  addMassTimes(motion.a, *forces.inertial);
  if (momentum) {
    addMassTimes(motion.v, *momentum);
  }
  multiply(products);
  for (std::size_t k = 0; k < matrices.branches.size(); ++k) {
    matrices.branches[k].stiffness->apply(*motion.d[k], *forces.branch_forces[k]);
    forces.elastic->update(1, *forces.branch_forces[k], 1);
  }
  if (motion.inelastic != nullptr) {
    forces.inelastic->putScalar(0);
    cells->addForces(*motion.inelastic, *forces.inelastic);
    forces.elastic->update(-1, *forces.inelastic, 1);
  }
}

void Body::residual(Vector const& l, Motion const& motion, Vector& result) const
{
  Tpetra::deep_copy(result, l);
  applyMass(motion.a, result, -1, 1);
  matrices.viscosity->apply(motion.v, result, Teuchos::NO_TRANS, -1, 1);
  matrices.stiffness->apply(motion.u, result, Teuchos::NO_TRANS, -1, 1);
  for (std::size_t k = 0; k < matrices.branches.size(); ++k) {
    matrices.branches[k].stiffness->apply(*motion.d[k], result, Teuchos::NO_TRANS, -1, 1);
  }
  if (motion.inelastic != nullptr) {
    cells->addForces(*motion.inelastic, result);
  }
}

void Body::clearHeld(Vector& x) const { clearAt(held.ownedOnDevice(), x); }

void clearAt(IndexView const& dofs, Vector& x)
{
  auto const values = x.getLocalViewDevice(Tpetra::Access::ReadWrite);
  Kokkos::parallel_for(
    "asperity::dynamics::clearAt", RangePolicy(0, dofs.extent_int(0)),
    KOKKOS_LAMBDA(int k) { values(dofs(k), 0) = 0; });
}
} // namespace asperity::dynamics
