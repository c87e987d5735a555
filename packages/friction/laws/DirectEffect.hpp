#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// The parameters of mu = mu* + a log(V / V*) + b alpha = a log(V / V_alpha), which the regularised
// and the truncated law keep from becoming negative (Pipping 2014, §1.2).
//
// V_alpha = V* exp(-(mu* + b alpha) / a) underflows for common parameters and never appears: all
// is said in x(V) = log(V / V_alpha) = log V + shift(alpha).
struct DirectEffect
{
  double a;
  double b;
  double reference_rate;     // V*, m/s
  double reference_friction; // mu*
  double log_reference_rate; // log(V* s/m)

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

  // -log(V_alpha s/m)
  KOKKOS_INLINE_FUNCTION double shift(double alpha) const
  {
    return (reference_friction + b * alpha) / a - log_reference_rate;
  }

  // The alpha at which log(V / V_alpha) = x; not a finite number if b = 0.
  KOKKOS_INLINE_FUNCTION double stateAt(double V, double x) const
  {
    return (a * (x - (math::log(V) - log_reference_rate)) - reference_friction) / b;
  }
};
} // namespace asperity::friction
