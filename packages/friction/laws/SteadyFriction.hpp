#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"
#include "friction/laws/SlipRelaxation.hpp"

namespace asperity::friction
{
// The slip law for a given steady friction f_ss(V) > 0 [-], for use with the regularised law (Noda,
// Dunham & Rice 2009). With psi = mu* + b alpha,
//
//   d(psi)/dt = -(V / L) (psi - psi_ss(V)),  psi_ss(V) = a ln[2 (V* / V) sinh(f_ss(V) / a)].
//
// V >= 0 is the slip rate [m/s], L [m] the characteristic slip distance, mu* [-] the reference
// friction at the reference slip rate V* [m/s], and a and b [-] are the weights of the direct
// effect and of the state. psi_ss is the state at which the regularised law has mu(V) = f_ss(V).
// Host and device.
//
// Law provides `name`, `parameters`, among them those of the members here, and steadyState(V),
// which calls stateOf.
template <class Law>
struct SteadyFriction
{
  double a;
  double b;
  double slip_distance;      // L, m
  double reference_rate;     // V*, m/s
  double reference_friction; // mu*
  double log_reference_rate; // ln(V* s/m)

  KOKKOS_INLINE_FUNCTION void prepare() { log_reference_rate = math::log(reference_rate); }

  // See LawProperties.hpp.
  static constexpr bool weakens_at_high_rates = true;
  double slipDistance() const { return slip_distance; }

  // d(alpha)/dt in 1/s.
  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return detail::relaxationRate(V, slip_distance, alpha, law().steadyState(V));
  }

  // alpha after the time dt >= 0 [s] at constant V, which is the exact solution.
  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    return detail::relaxed(V, dt, slip_distance, alpha0, law().steadyState(V));
  }

protected:
  // The alpha of psi_ss, from f_ss / a > 0 and ln(V / V*). The logarithm of 2 sinh is used, since
  // the hyperbolic sine overflows.
  KOKKOS_INLINE_FUNCTION double stateOf(double friction_over_a, double log_ratio) const
  {
    const double y = friction_over_a;
    const double log_two_sinh = y + math::log(-math::expm1(-2 * y));
    return (a * (log_two_sinh - log_ratio) - reference_friction) / b;
  }

private:
  KOKKOS_INLINE_FUNCTION Law const& law() const { return static_cast<Law const&>(*this); }
};
} // namespace asperity::friction
