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
  update.order = 1;
  update.mass_weight = 1;
  update.stiffness_weight = 1;
  update.velocity_in_acceleration = 1;
  return update;
}

RateUpdate RateUpdate::generalisedAlpha(double spectral_radius)
{
  const double lag = (spectral_radius - 1) / (spectral_radius + 1);
  const double gamma = 0.5 - lag;
  const double beta = (1 - lag) * (1 - lag) / 4;
  RateUpdate update;
  update.name = "Generalised Alpha";
  update.mass_weight = (1 - lag) / gamma;
  update.stiffness_weight = beta / gamma;
  update.velocity_in_displacement = 1 - beta / gamma;
  update.acceleration_in_displacement = 0.5 - beta / gamma;
  update.velocity_in_acceleration = (1 - lag) / gamma;
  update.acceleration_in_acceleration = (1 - lag) * (1 - gamma) / gamma - lag;
  update.lag = lag;
  return update;
}

void RateUpdate::laggingAcceleration(State const& from, double tau, Vector& A) const
{
  Tpetra::deep_copy(A, *from.a);
  if (lag != 0) {
    A.update(lag * tau, *from.jerk, 1);
  }
}

void RateUpdate::predict(State const& from, double tau, Vector& u_hat, Vector& a_hat) const
{
  laggingAcceleration(from, tau, a_hat);
  Tpetra::deep_copy(u_hat, *from.u);
  u_hat.update(tau * velocity_in_displacement, *from.v, tau * tau * acceleration_in_displacement,
               a_hat, 1);
  a_hat.update(velocity_in_acceleration / tau, *from.v, acceleration_in_acceleration);
}

void RateUpdate::complete(State const& from, Vector const& u_hat, Vector const& a_hat, double tau,
                          State& to) const
{
  to.u->update(1, u_hat, tau * stiffness_weight, *to.v, 0);
  laggingAcceleration(from, tau, *to.jerk);
  to.a->update(mass_weight / tau, *to.v, -1, a_hat, 0);
  const double per_time = 1 / ((1 - lag) * tau);
  to.jerk->update(per_time, *to.a, -per_time);
}
} // namespace asperity::dynamics
