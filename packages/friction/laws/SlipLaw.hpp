#pragma once

#include "friction/laws/SlipRelaxation.hpp"
#include "friction/laws/StateParameters.hpp"

namespace asperity::friction
{
// The slip law d(alpha)/dt = -(V / L) (log(V / V*) + alpha), Pipping 2014, (3);
// d(theta)/dt = -(V theta / L) log(V theta / L). Host and device; V >= 0 in m/s, dt >= 0 in s.
struct SlipLaw : StateParameters
{
  static constexpr char const* name = "Slip";

  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return detail::relaxationRate(V, slip_distance, alpha, steadyState(V));
  }

  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    return detail::relaxed(V, dt, slip_distance, alpha0, steadyState(V));
  }

  KOKKOS_INLINE_FUNCTION double steadyState(double V) const { return -logRatio(V); }
};
} // namespace asperity::friction
