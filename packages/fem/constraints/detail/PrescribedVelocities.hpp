#pragma once

#include "base/Types.hpp"
#include "fem/constraints/VelocityCondition.hpp"
#include "fem/constraints/detail/NodalBasis.hpp"
#include "portability/Views.hpp"

#include <vector>

namespace asperity::fem::detail
{
// An owned dof whose velocity is prescribed, and that velocity: the sum of the coefficients times
// the velocities of the conditions at the place of its node.
template <int Dim>
struct PrescribedDof
{
  int dof;
  Point<Dim> place;
  Terms terms;
};

// The velocities of these dofs in time. Those that do not depend on it are evaluated once and stay
// on the device, so that a step evaluates and copies the others alone.
template <int Dim>
class PrescribedVelocities
{
public:
  PrescribedVelocities(std::vector<VelocityCondition<Dim>> conditions,
                       std::vector<PrescribedDof<Dim>> const& dofs);

  // Sets v(owned dofs) to the prescribed velocities at the time t [s], and to zero at other dofs.
  void at(double t, Vector& v) const;
  // The dofs whose velocity may depend on time.
  std::vector<int> dofsThatVary() const;

private:
  bool dependsOnTime(PrescribedDof<Dim> const& dof) const;
  double velocity(PrescribedDof<Dim> const& dof, double t) const;

  std::vector<VelocityCondition<Dim>> conditions_;
  std::vector<PrescribedDof<Dim>> varying_;
  IndexView varying_dofs_, constant_dofs_;
  ConstNodeView constant_velocities_; // at constant_dofs_
};
} // namespace asperity::fem::detail
