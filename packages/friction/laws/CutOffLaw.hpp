#pragma once

#include "friction/LawProperties.hpp"
#include "friction/Types.hpp"
#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// Friction with a cut-off of the direct effect (Okubo 1989),
//
//   mu(V, alpha) = max(0, mu* + b alpha - a ln(1 + V_c / V)),
//
// with the slip rate V >= 0 [m/s], the state alpha = ln(theta V* / L) [-], the reference friction
// mu* [-], the weights a of the direct effect and b of the state [-], and the cut-off slip rate V_c
// [m/s]. Far below V_c it is mu* + a ln(V / V_c) + b alpha; far above V_c it depends on the state
// alone. Host and device; alpha may have any value.
struct CutOffLaw
{
  static constexpr char const* name = "Cut-Off";

  double a;
  double b;
  double cut_off;            // V_c, m/s
  double reference_friction; // mu*

  static constexpr ParameterOf<CutOffLaw> parameters[] = {
    {&CutOffLaw::a, parameter::direct_effect},
    {&CutOffLaw::b, parameter::state_effect},
    {&CutOffLaw::cut_off,
     {"Cut-Off Slip Rate", "m/s", no_default, Range::positive(),
      "The direct effect ends at slip rates about this one, V_c."}},
    {&CutOffLaw::reference_friction, parameter::reference_friction},
  };

  Sensitivity sensitivity() const { return {a, b}; } // far below the cut-off
  double referenceFriction() const { return reference_friction; }

  // The law at one state: mu(V) = max(0, level - a ln(1 + V_c / V)) with level = mu* + b alpha.
  struct Curve
  {
    double a;
    double level;       // mu* + b alpha
    double cut_off;     // V_c, m/s
    double log_cut_off; // ln(V_c s/m)

    KOKKOS_INLINE_FUNCTION double mu(double V) const { return detail::larger(difference(V), 0); }

    // dmu/dV in s/m. The kink is the slip rate at which mu becomes positive; there it is the
    // derivative from above.
    KOKKOS_INLINE_FUNCTION double derivative(double V) const
    {
      return difference(V) < 0 ? 0 : a / (V * (1 + V / cut_off));
    }

    KOKKOS_INLINE_FUNCTION Response response(double V) const
    {
      const double value = difference(V);
      if (value < 0) {
        return {0, 0, 0};
      }
      const double share = 1 / (1 + V / cut_off);
      return {value, a * share, -a * share * (1 - share)};
    }

    // The average of mu between V and V + h, mu(V) for h = 0; V + h >= 0.
    KOKKOS_INLINE_FUNCTION double mean(double V, double h) const
    {
      const double low = detail::larger(detail::smaller(V, V + h), 0);
      const double width = math::fabs(h);
      if (difference(low) >= 0) {
        return width == 0 ? mu(low) : meanAbove(low, width);
      }
      const double beyond = low + width - kink();
      return beyond > 0 ? beyond / width * meanAbove(kink(), beyond) : 0;
    }

    // The sum of the magnitudes of the terms of mu, which may nearly cancel; V > 0. Times the
    // rounding unit it is the size of the errors of mu and mean.
    KOKKOS_INLINE_FUNCTION double terms(double V) const
    {
      const bool slides = kinkedAt(V) || difference(V) > 0;
      return slides ? math::fabs(level) + a * (math::fabs(math::log(V)) + math::fabs(log_cut_off))
                    : 0;
    }

    // Whether mu has its kink at V, to the rounding of mu.
    KOKKOS_INLINE_FUNCTION bool kinkedAt(double V) const
    {
      return math::fabs(difference(V)) <= 4 * detail::epsilon * (a + math::fabs(level));
    }

  private:
    // level - a ln(1 + V_c / V), without overflow; -infinity at V = 0.
    KOKKOS_INLINE_FUNCTION double difference(double V) const
    {
      const double x = log_cut_off - math::log(V);
      return level - a * (x > 0 ? x + math::log1p(math::exp(-x)) : math::log1p(math::exp(x)));
    }

    // The slip rate [m/s] at which mu becomes positive, V_c / (exp(level / a) - 1). It is 0 where
    // that underflows, and infinite where mu is zero at every V, since level <= 0.
    KOKKOS_INLINE_FUNCTION double kink() const
    {
      return level > 0 ? cut_off / math::expm1(level / a) : infinity;
    }

    // The average of level - a [ln(V + V_c) - ln V] over V in [low, low + width]; width > 0.
    KOKKOS_INLINE_FUNCTION double meanAbove(double low, double width) const
    {
      const double high = low + width;
      if (low == 0) {
        return level -
               a * (math::log1p(cut_off / high) + cut_off / high * math::log1p(high / cut_off));
      }
      const double of_sum =
        detail::meanLog(low + cut_off, width, math::log(low + cut_off), math::log(high + cut_off));
      return level - a * (of_sum - detail::meanLog(low, width, math::log(low), math::log(high)));
    }
  };

  KOKKOS_INLINE_FUNCTION Curve at(double alpha) const
  {
    return {a, reference_friction + b * alpha, cut_off, math::log(cut_off)};
  }

  // The alpha at which mu(V, alpha) = mu; V > 0, mu > 0. It is not finite if b = 0.
  KOKKOS_INLINE_FUNCTION double stateFor(double V, double mu) const
  {
    return (mu + a * math::log1p(cut_off / V) - reference_friction) / b;
  }
};
} // namespace asperity::friction
