#pragma once

#include "friction/laws/StateParameters.hpp"

namespace asperity::friction
{
// The slip law d(alpha)/dt = -(V / L) (log(V / V*) + alpha), Pipping 2014, (3);
// d(theta)/dt = -(V theta / L) log(V theta / L). Host and device; V >= 0 in m/s, dt >= 0 in s.
struct SlipLaw : StateParameters
{
  static constexpr char const* name = "Slip";

  KOKKOS_INLINE_FUNCTION static SlipLaw load(ParameterView const& values, int node)
  {
    return {StateParameters::load(values, node)};
  }

  // d(alpha)/dt in 1/s. It is 0 at V = 0: without slip the state does not change.
  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return V == 0 ? 0 : -V / slip_distance * (logRatio(V) + alpha);
  }

  // alpha after dt at constant V: the distance beta = alpha - alpha_ss from the steady state
  // shrinks by exp(-q), q = V dt / L.
  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    const double q = V * dt / slip_distance;
    if (q == 0) {
      return alpha0;
    }
    const double steady = steadyState(V);
    const double beta = alpha0 - steady;
    return q < 0.5 ? alpha0 + beta * math::expm1(-q) : steady + beta * math::exp(-q);
  }

  KOKKOS_INLINE_FUNCTION double steadyState(double V) const { return -logRatio(V); }
};
} // namespace asperity::friction
