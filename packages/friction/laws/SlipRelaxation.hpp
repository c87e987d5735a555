#pragma once

#include "friction/detail/Math.hpp"

// A state that slip moves towards its steady state, d(alpha)/dt = -(V / L) (alpha - steady), where
// `steady` depends on V alone. Host and device; V >= 0 in m/s, L > 0 in m, dt >= 0 in s.
namespace asperity::friction::detail
{
// d(alpha)/dt in 1/s. It is 0 at V = 0: without slip the state does not change.
KOKKOS_INLINE_FUNCTION double relaxationRate(double V, double L, double alpha, double steady)
{
  return V == 0 ? 0 : -V / L * (alpha - steady);
}

// alpha after dt at constant V: the distance from the steady state shrinks by exp(-V dt / L).
KOKKOS_INLINE_FUNCTION double relaxed(double V, double dt, double L, double alpha0, double steady)
{
  const double q = V * dt / L;
  if (q == 0) {
    return alpha0;
  }
  const double beta = alpha0 - steady;
  return q < 0.5 ? alpha0 + beta * math::expm1(-q) : steady + beta * math::exp(-q);
}
} // namespace asperity::friction::detail
