#pragma once

#include "friction/Table.hpp"
#include "friction/laws/RateWeakening.hpp"

namespace asperity::friction
{
// The law of RateWeakening.hpp with a steady friction from a table:
//
//   d(psi)/dt = -(V / L) (psi - psi_ss),  psi_ss = a log[2 (V* / V) sinh(f_ss / a)],
//
// f_ss > 0 by log10(V s/m). Friction still increases with V at a given state, whatever the table.
// Host and device; V >= 0 in m/s.
struct TabulatedLaw
{
  static constexpr char const* name = "Tabulated";
  static constexpr Parameter parameters[5] = {
    DirectEffect::table[0], StrongRateWeakeningLaw::parameters[1],
    StrongRateWeakeningLaw::parameters[2], reference_slip_rate, DirectEffect::table[3]};
  static double slipDistance(double const* values) { return values[2]; }
  static constexpr bool weakens_at_high_rates = true;

  double a;
  double b;
  double slip_distance;           // L, m
  double log_reference_slip_rate; // log(V* s/m)
  double reference_friction;      // mu*
  Table table = {};               // given by LawStateKernels

  // Reads column `node` of values(num_parameters, num_nodes), rows in the order of the table.
  KOKKOS_INLINE_FUNCTION static TabulatedLaw load(ParameterView const& values, int node)
  {
    return {values(0, node), values(1, node), values(2, node), math::log(values(3, node)),
            values(4, node)};
  }

  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return detail::relaxationRate(V, slip_distance, alpha, steadyState(V));
  }

  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    return detail::relaxed(V, dt, slip_distance, alpha0, steadyState(V));
  }

  KOKKOS_INLINE_FUNCTION double steadyState(double V) const
  {
    constexpr double log10_of_e = 0.43429448190325182765;
    const double log_V = math::log(V);
    const double y = table(log10_of_e * log_V) / a;
    const double log_two_sinh = y + math::log(-math::expm1(-2 * y));
    return (a * (log_two_sinh - (log_V - log_reference_slip_rate)) - reference_friction) / b;
  }
};
} // namespace asperity::friction
