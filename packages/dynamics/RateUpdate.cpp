#include "dynamics/RateUpdate.hpp"

#include "dynamics/MeanDecay.hpp"

#include <Tpetra_Vector.hpp>

#include <cmath>

namespace asperity::dynamics
{
namespace
{
auto readOnly(Vector const& x) { return x.getLocalViewDevice(Tpetra::Access::ReadOnly); }
auto overwritten(Vector& x) { return x.getLocalViewDevice(Tpetra::Access::OverwriteAll); }
} // namespace

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
  update.velocity_error = 0.5;
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
  update.velocity_error = lag < 0 ? 1. / 12 - lag / 2 : 0;
  return update;
}

fem::Weights RateUpdate::weights(double tau, fem::BodyMatrices const& body) const
{
  fem::Weights result = {mass_weight / tau, 1, tau * stiffness_weight};
  for (auto const& branch : body.branches) {
    result.branches.push_back(meanDecay(tau / branch.time) * result.stiffness);
  }
  return result;
}

void RateUpdate::relax(fem::BodyMatrices const& body, State const& from, double tau,
                       Vector const& u1, std::vector<RCP<Vector>> const& d1)
{
  for (std::size_t k = 0; k < body.branches.size(); ++k) {
    const double time = body.branches[k].time, phi = meanDecay(tau / time);
    d1[k]->update(phi, u1, -phi, *from.u, 0);
    d1[k]->update(std::exp(-tau / time), *from.branches[k], 1);
  }
}

void RateUpdate::predict(State const& from, double tau, Vector& u_hat, Vector& a_hat) const
{
  auto const u0 = readOnly(*from.u), v0 = readOnly(*from.v);
  auto const a0 = readOnly(*from.a), j0 = readOnly(*from.jerk);
  auto const u = overwritten(u_hat), a = overwritten(a_hat);
  const double u_of_v = tau * velocity_in_displacement;
  const double u_of_A = tau * tau * acceleration_in_displacement;
  const double a_of_v = velocity_in_acceleration / tau;
  const double a_of_A = acceleration_in_acceleration;
  const double A_of_j = lag * tau;
  Kokkos::parallel_for(
    "asperity::dynamics::predict", RangePolicy(0, u.extent(0)), KOKKOS_LAMBDA(int dof) {
      const double A0 = a0(dof, 0) + A_of_j * j0(dof, 0);
      u(dof, 0) = u0(dof, 0) + u_of_v * v0(dof, 0) + u_of_A * A0;
      a(dof, 0) = a_of_v * v0(dof, 0) + a_of_A * A0;
    });
}

void RateUpdate::withVelocity(Vector const& velocity, Vector const& u_hat, Vector const& a_hat,
                              double tau, Vector& displacement, Vector& acceleration) const
{
  auto const v = readOnly(velocity), u0 = readOnly(u_hat), a0 = readOnly(a_hat);
  auto const u = overwritten(displacement), a = overwritten(acceleration);
  const double u_of_v = tau * stiffness_weight;
  const double a_of_v = mass_weight / tau;
  Kokkos::parallel_for(
    "asperity::dynamics::withVelocity", RangePolicy(0, u.extent(0)), KOKKOS_LAMBDA(int dof) {
      u(dof, 0) = u0(dof, 0) + u_of_v * v(dof, 0);
      a(dof, 0) = a_of_v * v(dof, 0) - a0(dof, 0);
    });
}

void RateUpdate::complete(State const& from, Vector const& u_hat, Vector const& a_hat, double tau,
                          State& to) const
{
  auto const a0 = readOnly(*from.a), j0 = readOnly(*from.jerk);
  auto const u = readOnly(u_hat), a = readOnly(a_hat), v1 = readOnly(*to.v);
  auto const u1 = overwritten(*to.u), a1 = overwritten(*to.a), j1 = overwritten(*to.jerk);
  const double u_of_v = tau * stiffness_weight;
  const double a_of_v = mass_weight / tau;
  const double A_of_j = lag * tau;
  const double per_time = 1 / ((1 - lag) * tau);
  Kokkos::parallel_for(
    "asperity::dynamics::complete", RangePolicy(0, u.extent(0)), KOKKOS_LAMBDA(int dof) {
      const double acceleration = a_of_v * v1(dof, 0) - a(dof, 0);
      const double A0 = a0(dof, 0) + A_of_j * j0(dof, 0);
      u1(dof, 0) = u(dof, 0) + u_of_v * v1(dof, 0);
      a1(dof, 0) = acceleration;
      j1(dof, 0) = per_time * acceleration - per_time * A0;
    });
}

void RateUpdate::meanVelocity(State const& from, double tau, Vector const& v1,
                              NodeDofView const& dofs, Vector& mean) const
{
  auto const v0 = readOnly(*from.v), a0 = readOnly(*from.a), j0 = readOnly(*from.jerk);
  auto const end = readOnly(v1);
  auto const result = mean.getLocalViewDevice(Tpetra::Access::ReadWrite);
  const double of_v0 = velocity_in_displacement;
  const double of_A0 = tau * acceleration_in_displacement;
  const double of_v1 = stiffness_weight;
  const double A_of_j = lag * tau;
  Kokkos::parallel_for(
    "asperity::dynamics::meanVelocityAt", RangePolicy(0, dofs.extent(0)), KOKKOS_LAMBDA(int node) {
      for (int k = 0; k < dofs.extent_int(1); ++k) {
        const int dof = dofs(node, k);
        result(dof, 0) =
          of_v0 * v0(dof, 0) + of_A0 * (a0(dof, 0) + A_of_j * j0(dof, 0)) + of_v1 * end(dof, 0);
      }
    });
}
} // namespace asperity::dynamics
