#pragma once

#include "base/Types.hpp"
#include "fem/BodyMatrices.hpp"
#include "fem/bulk/InelasticStrain.hpp"
#include "fem/constraints/HeldDofs.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace asperity::fem
{
class InelasticCells;
} // namespace asperity::fem

namespace asperity::dynamics
{
// What the forces in a body follow from, on the owned dofs in nodal frames: d_k(num_branches) of
// its Maxwell branches; the inelastic strain of its cells, null if it has none.
struct Motion
{
  Vector const& u;
  Vector const& v;
  Vector const& a;
  std::vector<RCP<Vector>> const& d;
  fem::TensorView const* inelastic = nullptr;
};

// The forces that resist a motion [N], in 2D per unit of thickness [N/m].
struct BodyForces
{
  RCP<Vector> elastic, viscous, inertial; // K u + sum of K_k d_k - p, C v, M a
  std::vector<RCP<Vector>> branch_forces; // K_k d_k
  RCP<Vector> inelastic;                  // p, null in a body without cells that yield

  // b -= M a + C v + K u + sum of K_k d_k - p, in one pass over the vectors.
  void subtractFrom(Vector& b) const;
};

// The body, in nodal frames (Pipping 2014, eq. 14; fem::MaxwellBranch, fem::InelasticCells):
//   M u'' + C u' + K u + sum of K_k d_k - p = load(t) + friction and reaction forces
// with the forces p of the inelastic strain.
struct Body
{
  std::shared_ptr<const fem::DofMap> dofs;
  fem::BodyMatrices matrices;
  fem::HeldDofs held;                     // dofs whose velocity is prescribed
  RCP<const MultiVector> near_null_space; // rigid body motions on the owned dofs, in nodal frames

  // Two functions that fill a vector of owned dofs for the time t [s].
  std::function<void(double, Vector&)> load;
  std::function<void(double, Vector&)> prescribed_velocity; // zero at dofs that are not held

  // The cells that may yield; null if no rank has one.
  std::shared_ptr<const fem::InelasticCells> cells = nullptr;

  int numOwnedDofs() const { return dofs->numOwnedNodes() * dofs->components(); }
  RCP<Vector> vector() const;
  std::vector<RCP<Vector>> branchVectors() const; // one for each Maxwell branch
  // y = alpha M x + beta y; the product is left out if the body has no mass.
  void applyMass(Vector const& x, Vector& y, double alpha, double beta) const;
  BodyForces noForces() const;
  // Also sets `momentum` to M v unless it is null. Reads each matrix once. In a massless body
  // inertial forces and momentum are zero.
  void computeForces(Motion const& motion, BodyForces& forces, Vector* momentum = nullptr) const;
  // l - M a - C v - K u - sum of K_k d_k + p
  void residual(Vector const& l, Motion const& motion, Vector& result) const;
  // x = 0 at the held dofs
  void clearHeld(Vector& x) const;
};

// x = 0 at these local dofs.
void clearAt(IndexView const& dofs, Vector& x);
} // namespace asperity::dynamics
