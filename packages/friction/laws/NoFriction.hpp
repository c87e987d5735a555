#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// A fault without friction: mu = 0 at every slip rate, with nothing to choose. What the fault bears
// is its cohesion. Host and device.
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

// The state that goes with it: it stays what it is.
struct NoState
{
  static constexpr char const* name = "None";
  static constexpr char const* state_variable = no_state;

  KOKKOS_INLINE_FUNCTION double rate(double, double) const { return 0; }
  KOKKOS_INLINE_FUNCTION double flow(double, double, double alpha0) const { return alpha0; }
  KOKKOS_INLINE_FUNCTION double steadyState(double) const { return 0; }
};
} // namespace asperity::friction
