#pragma once

#include "friction/laws/StateParameters.hpp"

namespace asperity::friction
{
// The ageing law (Dieterich 1979; Pipping 2014, equation 2),
//
//   d(theta)/dt = 1 - V theta / L,  hence  d(alpha)/dt = (V* exp(-alpha) - V) / L,
//
// with the state theta [s], alpha = ln(theta V* / L) [-], the slip rate V >= 0 [m/s], the reference
// slip rate V* [m/s] and the characteristic slip distance L [m]. The state grows with time even
// without slip. Host and device.
struct AgeingLaw : StateParameters
{
  static constexpr char const* name = "Ageing";
  static constexpr char const* nucleation_source =
    "ageing law on an endless fault, Rubin & Ampuero 2005; this is an estimate: slightly shorter "
    "zones may rupture, too";

  // d(alpha)/dt in 1/s.
  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return (reference_rate * math::exp(-alpha) - V) / slip_distance;
  }

  // alpha after the time dt >= 0 [s] at constant V, which is the exact solution: with q = V dt / L,
  //
  //   exp(alpha1) = exp(alpha0 - q) + (V* dt / L) (1 - exp(-q)) / q.
  //
  // The first term is the part of theta V* / L from before, the second one has grown since. Both
  // may overflow or underflow, so that only their logarithms are computed.
  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    const double q = V * dt / slip_distance;
    const double left = alpha0 - q;
    const double ageing = q > 0 ? -math::expm1(-q) / q : 1;
    const double healed = math::log(reference_rate * dt / slip_distance * ageing);
    return detail::larger(left, healed) + math::log1p(math::exp(-math::fabs(left - healed)));
  }

  // alpha = -ln(V / V*), for which theta = L / V.
  KOKKOS_INLINE_FUNCTION double steadyState(double V) const { return -logRatio(V); }
};
} // namespace asperity::friction
