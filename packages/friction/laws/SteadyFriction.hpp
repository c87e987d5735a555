#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"
#include "friction/laws/SlipRelaxation.hpp"

namespace asperity::friction
{
// The slip law for steady friction f_ss > 0 that is any function of the slip rate, with the
// regularised law and psi = mu* + b alpha:
//
//   d(psi)/dt = -(V / L) (psi - psi_ss),  psi_ss = a log[2 (V* / V) sinh(f_ss / a)]
//
// Law gives `name`, `parameters`, among them those of the members here, and steadyState(V), which
// calls stateOf. Host and device; V >= 0 in m/s.
template <class Law>
struct SteadyFriction
{
  double a;
  double b;
  double slip_distance;      // L, m
  double reference_rate;     // V*, m/s
  double reference_friction; // mu*
  double log_reference_rate; // log(V* s/m)

  KOKKOS_INLINE_FUNCTION void prepare() { log_reference_rate = math::log(reference_rate); }

  // See LawProperties.hpp.
  static constexpr bool weakens_at_high_rates = true;
  double slipDistance() const { return slip_distance; }

  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return detail::relaxationRate(V, slip_distance, alpha, law().steadyState(V));
  }

  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    return detail::relaxed(V, dt, slip_distance, alpha0, law().steadyState(V));
  }

protected:
  // alpha of psi_ss, by f_ss / a > 0 and log(V / V*).
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
