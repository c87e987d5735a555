#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// The parameters of the logarithmic law of friction (Dieterich 1979; Pipping 2014, section 1.2),
//
//   mu(V, alpha) = mu* + a ln(V / V*) + b alpha = a ln(V / V_alpha),
//   V_alpha = V* exp(-(mu* + b alpha) / a),
//
// with the slip rate V [m/s], the state alpha = ln(theta V* / L) [-], the reference friction mu*
// [-] at the reference slip rate V* [m/s], and the weights a of the direct effect and b of the
// state [-]. Below V_alpha this mu is negative; the regularised and the truncated law replace it
// there.
//
// V_alpha underflows for common parameters. Both laws therefore compute with
// x(V) = ln(V / V_alpha) = ln V + shift(alpha).
struct DirectEffect
{
  double a;
  double b;
  double reference_rate;     // V*, m/s
  double reference_friction; // mu*
  double log_reference_rate; // ln(V* s/m)

  static constexpr ParameterOf<DirectEffect> parameters[] = {
    {&DirectEffect::a, parameter::direct_effect},
    {&DirectEffect::b, parameter::state_effect},
    {&DirectEffect::reference_rate, parameter::reference_slip_rate},
    {&DirectEffect::reference_friction, parameter::reference_friction},
  };

  KOKKOS_INLINE_FUNCTION void prepare() { log_reference_rate = math::log(reference_rate); }

  // See LawProperties.hpp.
  Sensitivity sensitivity() const { return {a, b}; }
  double referenceFriction() const { return reference_friction; }

  // -ln(V_alpha s/m) = (mu* + b alpha) / a - ln(V* s/m)
  KOKKOS_INLINE_FUNCTION double shift(double alpha) const
  {
    return (reference_friction + b * alpha) / a - log_reference_rate;
  }

  // The alpha at which ln(V / V_alpha) = x. It is not finite if b = 0.
  KOKKOS_INLINE_FUNCTION double stateAt(double V, double x) const
  {
    return (a * (x - (math::log(V) - log_reference_rate)) - reference_friction) / b;
  }
};
} // namespace asperity::friction
