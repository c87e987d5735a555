#pragma once

#include "friction/laws/SteadyFriction.hpp"

namespace asperity::friction
{
// Steady friction that falls steeply at coseismic slip rates (Noda, Dunham & Rice 2009):
//
//   f_ss = f_w + (f_LV - f_w) share(V / V_w),
//   f_LV = a asinh[(V / V*)^(1 - b/a) exp(mu* / a) / 2] = mu* - (b - a) log(V / V*)
//
// to rounding where f_LV exceeds a few a; in this form it is positive at every slip rate. Far below
// V_w, where the share is 1, this is the slip law. Host and device; V >= 0 in m/s.
//
// Law gives `name` and share(log(V / V_w)) in (0, 1], which does not increase.
template <class Law>
struct RateWeakening : SteadyFriction<Law>
{
  using Base = SteadyFriction<Law>;
  using Base::a;
  using Base::b;

  double weakened_friction;  // f_w
  double weakening_rate;     // V_w, m/s
  double log_weakening_rate; // log(V_w s/m)

  static constexpr ParameterOf<RateWeakening> parameters[] = {
    {&RateWeakening::a, parameter::direct_effect},
    {&RateWeakening::b, parameter::positive_state_effect},
    {&RateWeakening::slip_distance, parameter::slip_distance},
    {&RateWeakening::reference_rate, parameter::reference_slip_rate},
    {&RateWeakening::reference_friction, parameter::reference_friction},
    {&RateWeakening::weakened_friction,
     {"Weakened Friction Coefficient", "-", 0.2, 0, infinity, true, false,
      "Steady friction falls towards this coefficient f_w at slip rates far above the weakening "
      "slip rate."}},
    {&RateWeakening::weakening_rate,
     {"Weakening Slip Rate", "m/s", 0.1, 0, infinity, false, false,
      "Steady friction falls at slip rates above this one, V_w."}},
  };

  KOKKOS_INLINE_FUNCTION void prepare()
  {
    Base::prepare();
    log_weakening_rate = math::log(weakening_rate);
  }

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
