#pragma once

#include "base/Types.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace asperity::dynamics
{
// How displacement and acceleration at the end of a step follow from the velocity there (Pipping
// 2014, table 3.1):
//
//   u1 = u^ + tau w_K v1,      u^ = u0 + tau c_v v0 + tau^2 c_a a0,      w_K = 1 / lambda_K
//   a1 = lambda_M / tau v1 - a^,    a^ = d_v / tau v0 + d_a a0
//
// Newmark: u1 = u0 + tau v0 + tau^2/2 ((1 - 2 beta) a0 + 2 beta a1), v1 = v0 + tau (a0 + a1)/2.
// Backward Euler: u1 = u0 + tau v1, v1 = v0 + tau a1.
struct RateUpdate
{
  std::string name;
  double mass_weight = 0;                                                // lambda_M
  double stiffness_weight = 0;                                           // 1 / lambda_K
  double velocity_in_displacement = 0, acceleration_in_displacement = 0; // c_v, c_a
  double velocity_in_acceleration = 0, acceleration_in_acceleration = 0; // d_v, d_a

  // Second order; unconditionally stable for beta in [1/4, 1/2].
  static RateUpdate newmark(double beta);
  // First order, damps everything.
  static RateUpdate backwardEuler();

  // u^ and a^ for a step of tau [s] from u0, v0, a0.
  void predict(Vector const& u0, Vector const& v0, Vector const& a0, double tau, Vector& u_hat,
               Vector& a_hat) const;
  // In place: u^ -> u1, a^ -> a1.
  void complete(Vector const& v1, double tau, Vector& u, Vector& a) const;
};
} // namespace asperity::dynamics
