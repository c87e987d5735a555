#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// A fault without friction: mu(V, alpha) = 0 at every slip rate V and state alpha. The fault bears
// its cohesion alone, and the law has no parameters. Host and device.
struct NoFriction
{
  static constexpr char const* name = "None";
  static constexpr char const* state_variable = no_state;

  struct Curve
  {
    KOKKOS_INLINE_FUNCTION double mu(double) const { return 0; }
    KOKKOS_INLINE_FUNCTION double derivative(double) const { return 0; }
    KOKKOS_INLINE_FUNCTION Response response(double) const { return {0, 0, 0}; }
    KOKKOS_INLINE_FUNCTION double mean(double, double) const { return 0; }
    KOKKOS_INLINE_FUNCTION bool kinkedAt(double) const { return false; }
  };

  KOKKOS_INLINE_FUNCTION Curve at(double) const { return {}; }
  KOKKOS_INLINE_FUNCTION double stateFor(double, double) const { return infinity; }
};

// The state law for a fault without friction: d(alpha)/dt = 0. Host and device.
struct NoState
{
  static constexpr char const* name = "None";
  static constexpr char const* state_variable = no_state;

  KOKKOS_INLINE_FUNCTION double rate(double, double) const { return 0; }
  KOKKOS_INLINE_FUNCTION double flow(double, double, double alpha0) const { return alpha0; }
  KOKKOS_INLINE_FUNCTION double steadyState(double) const { return 0; }
};
} // namespace asperity::friction
