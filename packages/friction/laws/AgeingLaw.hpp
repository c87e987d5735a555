#pragma once

#include "friction/laws/StateParameters.hpp"

namespace asperity::friction
{
// The ageing law d(alpha)/dt = (V* exp(-alpha) - V) / L, Pipping 2014, (2); d(theta)/dt = 1 - V
// theta / L. Host and device; V >= 0 in m/s, dt >= 0 in s.
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

  // alpha after dt at constant V. With q = V dt / L,
  //   exp(alpha1) = exp(alpha0 - q) + (V* dt / L) (1 - exp(-q)) / q.
  // The first term is what is left of the old contact, the second what has healed since. They are
  // added as logarithms.
  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    const double q = V * dt / slip_distance;
    const double left = alpha0 - q;
    const double ageing = q > 0 ? -math::expm1(-q) / q : 1;
    const double healed = math::log(reference_rate * dt / slip_distance * ageing);
    return detail::larger(left, healed) + math::log1p(math::exp(-math::fabs(left - healed)));
  }

  KOKKOS_INLINE_FUNCTION double steadyState(double V) const { return -logRatio(V); }
};
} // namespace asperity::friction
