#include "dynamics/RateUpdate.hpp"

#include <Tpetra_Vector.hpp>

namespace asperity::dynamics
{
RateUpdate RateUpdate::newmark(double beta)
{
  RateUpdate update;
  update.name = "Newmark";
  update.mass_weight = 2;
  update.stiffness_weight = 2 * beta;
  update.velocity_in_displacement = 1 - 2 * beta;
  update.acceleration_in_displacement = (1 - 4 * beta) / 2;
  update.velocity_in_acceleration = 2;
  update.acceleration_in_acceleration = 1;
  return update;
}

RateUpdate RateUpdate::backwardEuler()
{
  RateUpdate update;
  update.name = "Backward Euler";
  update.mass_weight = 1;
  update.stiffness_weight = 1;
  update.velocity_in_acceleration = 1;
  return update;
}

void RateUpdate::predict(Vector const& u0, Vector const& v0, Vector const& a0, double tau,
                         Vector& u_hat, Vector& a_hat) const
{
  Tpetra::deep_copy(u_hat, u0);
  u_hat.update(tau * velocity_in_displacement, v0, tau * tau * acceleration_in_displacement, a0, 1);
  a_hat.update(velocity_in_acceleration / tau, v0, acceleration_in_acceleration, a0, 0);
}

void RateUpdate::complete(Vector const& v1, double tau, Vector& u, Vector& a) const
{
  u.update(tau * stiffness_weight, v1, 1);
  a.update(mass_weight / tau, v1, -1);
}
} // namespace asperity::dynamics
