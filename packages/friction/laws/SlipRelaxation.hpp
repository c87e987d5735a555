#pragma once

#include "friction/detail/Math.hpp"

// A state that approaches its steady state in proportion to slip,
//
//   d(alpha)/dt = -(V / L) (alpha - alpha_ss(V)),
//
// with the state alpha [-], its steady value alpha_ss [-] (`steady`), the slip rate V >= 0 [m/s]
// and the characteristic slip distance L > 0 [m]. Host and device.
namespace asperity::friction::detail
{
// d(alpha)/dt in 1/s. It is 0 at V = 0, where `steady` may be infinite.
KOKKOS_INLINE_FUNCTION double relaxationRate(double V, double L, double alpha, double steady)
{
  return V == 0 ? 0 : -V / L * (alpha - steady);
}

// alpha after the time dt >= 0 [s] at constant V, from alpha0:
//   alpha_ss + (alpha0 - alpha_ss) exp(-V dt / L).
// For small V dt / L it is written as a change of alpha0, which loses no digits of that change.
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
