#pragma once

#include "friction/laws/DirectEffect.hpp"
#include "friction/laws/SlipRelaxation.hpp"

namespace asperity::friction
{
// The slip law for steady friction f_ss > 0 that is any function of the slip rate, with the
// regularised law and psi = mu* + b alpha:
//
//   d(psi)/dt = -(V / L) (psi - psi_ss),  psi_ss = a log[2 (V* / V) sinh(f_ss / a)]
//
// Law gives `name`, `parameters`, which begin with those here, and steadyState(V), which calls
// stateOf. Host and device; V >= 0 in m/s.
template <class Law>
struct SteadyFriction
{
  static constexpr Parameter b_parameter = {
    "b",
    "-",
    no_default,
    0,
    infinity,
    false,
    false,
    "This is the weight of the state: mu grows by this value when the state theta grows by a "
    "factor e."};
  static constexpr Parameter L_parameter = {
    "L",
    "m",
    no_default,
    0,
    infinity,
    false,
    false,
    "This is the characteristic slip distance, over which the state adapts to a new slip rate."};
  static double slipDistance(double const* values) { return values[2]; }
  static constexpr bool weakens_at_high_rates = true;

  double a;
  double b;
  double slip_distance;           // L, m
  double log_reference_slip_rate; // log(V* s/m)
  double reference_friction;      // mu*

  // Reads column `node` of values(num_parameters, num_nodes): a, b, L, V*, mu* and those of Law.
  KOKKOS_INLINE_FUNCTION static SteadyFriction load(ParameterView const& values, int node)
  {
    return {values(0, node), values(1, node), values(2, node), math::log(values(3, node)),
            values(4, node)};
  }

  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return detail::relaxationRate(V, slip_distance, alpha, law().steadyState(V));
  }

  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    return detail::relaxed(V, dt, slip_distance, alpha0, law().steadyState(V));
  }

protected:
  // alpha of psi_ss, by f_ss / a > 0 and log(V / V*).
  KOKKOS_INLINE_FUNCTION double stateOf(double friction_over_a, double log_ratio) const
  {
    const double y = friction_over_a;
    const double log_two_sinh = y + math::log(-math::expm1(-2 * y));
    return (a * (log_two_sinh - log_ratio) - reference_friction) / b;
  }

private:
  KOKKOS_INLINE_FUNCTION Law const& law() const { return static_cast<Law const&>(*this); }
};
} // namespace asperity::friction
