#pragma once

#include "friction/laws/DirectEffect.hpp"
#include "friction/laws/SlipRelaxation.hpp"

namespace asperity::friction
{
// The slip law with a steady friction that falls steeply at coseismic slip rates (Noda, Dunham &
// Rice 2009), for the regularised law with psi = mu* + b alpha:
//
//   d(psi)/dt = -(V / L) (psi - psi_ss),  psi_ss = a log[2 (V* / V) sinh(f_ss / a)],
//   f_ss = f_w + (f_LV - f_w) share(V / V_w),
//   f_LV = a asinh[(V / V*)^(1 - b/a) exp(mu* / a) / 2] = mu* - (b - a) log(V / V*)
//
// to rounding where f_LV exceeds a few a; in this form it is positive at every slip rate. Far below
// V_w, where the share is 1, this is the slip law. Host and device; V >= 0 in m/s.
//
// Law gives `name` and share(log(V / V_w)) in (0, 1], which does not increase.
template <class Law>
struct RateWeakening
{
  static constexpr Parameter parameters[7] = {
    DirectEffect::table[0],
    {"b", "-", no_default, 0, infinity, false, false,
     "This is the weight of the state: mu grows by this value when the state theta grows by a "
     "factor e."},
    {"L", "m", no_default, 0, infinity, false, false,
     "This is the characteristic slip distance, over which the state adapts to a new slip rate."},
    reference_slip_rate,
    DirectEffect::table[3],
    {"Weakened Friction Coefficient", "-", 0.2, 0, infinity, true, false,
     "Steady friction falls towards this coefficient f_w at slip rates far above the weakening "
     "slip rate."},
    {"Weakening Slip Rate", "m/s", 0.1, 0, infinity, false, false,
     "Steady friction falls at slip rates above this one, V_w."},
  };
  static double slipDistance(double const* values) { return values[2]; }
  static constexpr bool weakens_at_high_rates = true;

  double a;
  double b;
  double slip_distance;           // L, m
  double log_reference_slip_rate; // log(V* s/m)
  double reference_friction;      // mu*
  double weakened_friction;       // f_w
  double log_weakening_rate;      // log(V_w s/m)

  // Reads column `node` of values(num_parameters, num_nodes), rows in the order of the table.
  KOKKOS_INLINE_FUNCTION static Law load(ParameterView const& values, int node)
  {
    return {{values(0, node), values(1, node), values(2, node), math::log(values(3, node)),
             values(4, node), values(5, node), math::log(values(6, node))}};
  }

  KOKKOS_INLINE_FUNCTION double rate(double V, double alpha) const
  {
    return detail::relaxationRate(V, slip_distance, alpha, steadyState(V));
  }

  KOKKOS_INLINE_FUNCTION double flow(double V, double dt, double alpha0) const
  {
    return detail::relaxed(V, dt, slip_distance, alpha0, steadyState(V));
  }

  KOKKOS_INLINE_FUNCTION double steadyState(double V) const
  {
    const double log_V = math::log(V);
    const double x = log_V - log_reference_slip_rate;
    const double share = Law::share(log_V - log_weakening_rate);
    if (share == 1) {
      return -x;
    }
    const double slow = a * detail::asinhHalfExp((reference_friction + (a - b) * x) / a);
    const double y = (weakened_friction + (slow - weakened_friction) * share) / a;
    const double log_two_sinh = y + math::log(-math::expm1(-2 * y));
    return (a * (log_two_sinh - x) - reference_friction) / b;
  }
};

// share = (1 + (V / V_w)^8)^(-1/8), Dunham et al. 2011, the law of SCEC's TPV103 to TPV105.
struct StrongRateWeakeningLaw : RateWeakening<StrongRateWeakeningLaw>
{
  static constexpr char const* name = "Strong Rate Weakening";

  KOKKOS_INLINE_FUNCTION static double share(double log_ratio)
  {
    const double x = 8 * log_ratio;
    return x > 0 ? math::exp(-(x + math::log1p(math::exp(-x))) / 8)
                 : math::exp(-math::log1p(math::exp(x)) / 8);
  }
};

// share = min(1, V_w / V): contacts of asperities weaken by flash heating (Rice 2006).
struct FlashHeatingLaw : RateWeakening<FlashHeatingLaw>
{
  static constexpr char const* name = "Flash Heating";

  KOKKOS_INLINE_FUNCTION static double share(double log_ratio)
  {
    return log_ratio > 0 ? math::exp(-log_ratio) : 1;
  }
};
} // namespace asperity::friction
