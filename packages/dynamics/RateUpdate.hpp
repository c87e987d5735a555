#pragma once

#include "base/Views.hpp"
#include "dynamics/State.hpp"
#include "fem/BodyMatrices.hpp"

#include <string>

namespace asperity::dynamics
{
// How displacement and acceleration at the end of a step follow from the velocity there (Pipping
// 2014, table 3.1, and one scheme more):
//
//   u1 = u^ + tau w_K v1,           u^ = u0 + tau c_v v0 + tau^2 c_a A0,      w_K = 1 / lambda_K
//   a1 = lambda_M / tau v1 - a^,    a^ = d_v / tau v0 + d_a A0
//   A0 = a0 + alpha_M tau j0,       j1 = (a1 - A0) / ((1 - alpha_M) tau)
//
// In all schemes M a1 + C v1 + K u1 + sum of K_k d1_k = l1 - f1 holds at the end of the step. A is
// the scheme's own acceleration: it lags behind a by |alpha_M| steps, and equals a if alpha_M = 0.
// A state stores the jerk j instead of A, because A0 has to lag by a share of the step to come:
// with the A of the last step, a change of the step size would cost an order of accuracy.
//
// Newmark: u1 = u0 + tau v0 + tau^2/2 ((1 - 2 beta) a0 + 2 beta a1), v1 = v0 + tau (a0 + a1)/2.
// Backward Euler: u1 = u0 + tau v1, v1 = v0 + tau a1.
// Generalised alpha: Newmark's formulas with gamma = 1/2 - alpha_M, beta = (1 - alpha_M)^2/4 and A
// instead of a, where a1 = (1 - alpha_M) A1 + alpha_M A0 (Wood, Bossak and Zienkiewicz 1980;
// Chung and Hulbert 1993 with alpha_f = 0, so that friction and state enter at the end of the step
// and the rate problem stays convex).
struct RateUpdate
{
  std::string name;
  int order = 2;                                                         // of convergence in tau
  double mass_weight = 0;                                                // lambda_M
  double stiffness_weight = 0;                                           // 1 / lambda_K
  double velocity_in_displacement = 0, acceleration_in_displacement = 0; // c_v, c_a
  double velocity_in_acceleration = 0, acceleration_in_acceleration = 0; // d_v, d_a
  double lag = 0;                                                        // alpha_M <= 0
  // c, where a step from a smooth motion ends with v1 wrong by c tau^(p+1) d^(p+1)v/dt^(p+1) for
  // the order p; 0 where a scheme damps nothing, so that v has what no step has ever resolved.
  double velocity_error = 0;

  // Whether a fault that may open can be stepped with inertia (StepOpening): accelerations of the
  // past have no part in u1 and, if they have one in a1, this is the trapezoidal rule.
  bool allowsContact() const
  {
    return acceleration_in_displacement == 0 && lag == 0 &&
           (acceleration_in_acceleration == 0 || acceleration_in_acceleration == 1);
  }

  // Second order; unconditionally stable for beta in [1/4, 1/2].
  static RateUpdate newmark(double beta);
  // First order; damps all modes.
  static RateUpdate backwardEuler();
  // Second order, unconditionally stable; a step much longer than a mode's period multiplies the
  // mode by the spectral radius in [0, 1]: 0 removes it, 1 is Newmark with beta = 1/4.
  static RateUpdate generalisedAlpha(double spectral_radius);

  // Z = lambda_M / tau M + C + tau / lambda_K (K + sum of phi_k K_k), the derivative of the forces
  // at the end of a step by v1; phi_k of relax().
  fem::Weights weights(double tau, fem::BodyMatrices const& body) const;
  // u^ and a^ for a step of tau [s].
  void predict(State const& from, double tau, Vector& u_hat, Vector& a_hat) const;
  // u1 and a1 for the velocity v1 = `velocity`.
  void withVelocity(Vector const& velocity, Vector const& u_hat, Vector const& a_hat, double tau,
                    Vector& displacement, Vector& acceleration) const;
  // The Maxwell branches of the body at the end of a step, exact where u' is constant in it:
  //   d1 = exp(-tau / t_k) d0 + phi_k (u1 - u0),   phi_k = (1 - exp(-tau / t_k)) t_k / tau
  // d1(num_branches) must not be those of `from`.
  static void relax(fem::BodyMatrices const& body, State const& from, double tau, Vector const& u1,
                    std::vector<RCP<Vector>> const& d1);
  // Computes u, a and the jerk of `to`, whose v holds v1 already.
  void complete(State const& from, Vector const& u_hat, Vector const& a_hat, double tau,
                State& to) const;
  // (u1 - u0) / tau for the velocity v1 at the end of the step, at the given dofs alone; without
  // the difference of displacements, whose rounding exceeds the motion of a locked fault.
  void meanVelocity(State const& from, double tau, Vector const& v1, NodeDofView const& dofs,
                    Vector& mean) const;
};
} // namespace asperity::dynamics
