#pragma once

#include "friction/laws/SlipRelaxation.hpp"
#include "friction/laws/StateParameters.hpp"

namespace asperity::friction
{
// The slip law (Ruina 1983; Pipping 2014, equation 3),
//
//   d(theta)/dt = -(V theta / L) ln(V theta / L),
//   hence  d(alpha)/dt = -(V / L) (alpha + ln(V / V*)),
//
// with the state theta [s], alpha = ln(theta V* / L) [-], the slip rate V >= 0 [m/s], the reference
// slip rate V* [m/s] and the characteristic slip distance L [m]. The state changes only with slip.
// Host and device.
struct SlipLaw : StateParameters
{
  static constexpr char const* name = "Slip";

  // d(alpha)/dt in 1/s.
  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return detail::relaxationRate(V, slip_distance, alpha, steadyState(V));
  }

  // alpha after the time dt >= 0 [s] at constant V, which is the exact solution.
  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    return detail::relaxed(V, dt, slip_distance, alpha0, steadyState(V));
  }

  // alpha = -ln(V / V*), for which theta = L / V.
  KOKKOS_INLINE_FUNCTION double steadyState(double V) const { return -logRatio(V); }
};
} // namespace asperity::friction
