#pragma once

#include "friction/laws/SteadyFriction.hpp"

namespace asperity::friction
{
// State laws (SteadyFriction) whose steady friction falls steeply at the slip rates of earthquakes
// (Noda, Dunham & Rice 2009):
//
//   f_ss(V) = f_w + (f_LV(V) - f_w) share(V / V_w),
//   f_LV(V) = a asinh[(V / V*)^(1 - b/a) exp(mu* / a) / 2].
//
// V >= 0 is the slip rate [m/s], f_w [-] the weakened friction, V_w [m/s] the weakening slip rate,
// f_LV [-] the friction at low slip rates, mu* [-] the reference friction at the reference slip
// rate V* [m/s], and a and b [-] are the weights of the direct effect and of the state. Where f_LV
// is more than a few times a, it equals mu* - (b - a) ln(V / V*) up to rounding; it is positive at
// every slip rate. Far below V_w the share is 1, and the law is the slip law. Host and device.
//
// Law provides `name` and share(ln(V / V_w)) in (0, 1], which does not increase.
template <class Law>
struct RateWeakening : SteadyFriction<Law>
{
  using Base = SteadyFriction<Law>;
  using Base::a;
  using Base::b;

  double weakened_friction;  // f_w
  double weakening_rate;     // V_w, m/s
  double log_weakening_rate; // ln(V_w s/m)

  static constexpr ParameterOf<RateWeakening> parameters[] = {
    {&RateWeakening::a, parameter::direct_effect},
    {&RateWeakening::b, parameter::positive_state_effect},
    {&RateWeakening::slip_distance, parameter::slip_distance},
    {&RateWeakening::reference_rate, parameter::reference_slip_rate},
    {&RateWeakening::reference_friction, parameter::reference_friction},
    {&RateWeakening::weakened_friction,
     {"Weakened Friction Coefficient", "-", 0.2, Range::atLeast(0),
      "Steady friction falls towards this coefficient f_w at slip rates far above the weakening "
      "slip rate."}},
    {&RateWeakening::weakening_rate,
     {"Weakening Slip Rate", "m/s", 0.1, Range::positive(),
      "Steady friction falls at slip rates above this one, V_w."}},
  };

  KOKKOS_INLINE_FUNCTION void prepare()
  {
    Base::prepare();
    log_weakening_rate = math::log(weakening_rate);
  }

  // The alpha [-] at which friction at V is f_ss(V).
  KOKKOS_INLINE_FUNCTION double steadyState(double V) const
  {
    const double log_V = math::log(V);
    const double x = log_V - this->log_reference_rate;
    const double share = Law::share(log_V - log_weakening_rate);
    if (share == 1) {
      return -x;
    }
    const double slow = a * detail::asinhHalfExp((this->reference_friction + (a - b) * x) / a);
    return this->stateOf((weakened_friction + (slow - weakened_friction) * share) / a, x);
  }
};

// Strong rate weakening (Dunham et al. 2011), as in the benchmarks TPV103 to TPV105 of SCEC:
//   share = (1 + (V / V_w)^8)^(-1/8).
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

// Flash heating of the contacts between asperities (Rice 2006):
//   share = min(1, V_w / V).
struct FlashHeatingLaw : RateWeakening<FlashHeatingLaw>
{
  static constexpr char const* name = "Flash Heating";

  KOKKOS_INLINE_FUNCTION static double share(double log_ratio)
  {
    return log_ratio > 0 ? math::exp(-log_ratio) : 1;
  }
};
} // namespace asperity::friction
