#pragma once

#include "friction/laws/DirectEffect.hpp"

namespace asperity::friction
{
// The truncated law (Pipping 2014, equation 6),
//
//   mu(V, alpha) = a max(ln(V / V_alpha), 0),
//
// with the slip rate V >= 0 [m/s], the state alpha [-], and a [-] and V_alpha [m/s] of
// DirectEffect. There is no friction below V_alpha, where the law has a kink. Host and device;
// alpha may have any value.
struct TruncatedLaw : DirectEffect
{
  static constexpr char const* name = "Truncated";

  // The law at one state, a function of the slip rate alone: mu(V) = a max(x(V), 0) with
  // x(V) = ln(V / V_alpha).
  struct Curve
  {
    double a;
    double shift; // -ln(V_alpha s/m)

    KOKKOS_INLINE_FUNCTION double logRatio(double V) const { return math::log(V) + shift; }

    KOKKOS_INLINE_FUNCTION double mu(double V) const { return a * detail::larger(logRatio(V), 0); }

    // dmu/dV in s/m; at the kink it is the derivative from above.
    KOKKOS_INLINE_FUNCTION double derivative(double V) const { return logRatio(V) < 0 ? 0 : a / V; }

    KOKKOS_INLINE_FUNCTION Response response(double V) const
    {
      const double x = logRatio(V);
      return x < 0 ? Response{0, 0, 0} : Response{a * x, a, 0};
    }

    // The average of mu between V and V + h, mu(V) for h = 0; V + h >= 0. Multiplied by h it is
    // the difference of mubar, the integral of mu, accurate to the relative rounding of this
    // difference.
    KOKKOS_INLINE_FUNCTION double mean(double V, double h) const
    {
      const double low = detail::larger(detail::smaller(V, V + h), 0);
      const double width = math::fabs(h);
      const double x0 = logRatio(low);
      const double x1 = logRatio(low + width);
      if (x0 >= 0) {
        return a * detail::meanLog(low, width, x0, x1);
      }
      return x1 > 0 ? a * (1 + low / width) * meanFromKink(x1) : 0;
    }

    // The sum of the magnitudes of the terms of mu, including ln V and shift, which may nearly
    // cancel; V > 0. Times the rounding unit it is the size of the errors of mu and mean.
    KOKKOS_INLINE_FUNCTION double terms(double V) const
    {
      const bool slides = kinkedAt(V) || logRatio(V) > 0;
      return slides ? a * (math::fabs(math::log(V)) + math::fabs(shift)) : 0;
    }

    // Whether V is V_alpha, to the rounding of x(V), which is a difference.
    KOKKOS_INLINE_FUNCTION bool kinkedAt(double V) const
    {
      const double rounding = 4 * detail::epsilon * (1 + math::fabs(shift));
      return math::fabs(logRatio(V)) <= rounding;
    }

  private:
    // (1 / V1) times the integral of ln(V / V_alpha) from V_alpha to V1, which is x - 1 + exp(-x)
    // with x = ln(V1 / V_alpha) > 0. For small x its terms cancel, and a series replaces them.
    KOKKOS_INLINE_FUNCTION static double meanFromKink(double x)
    {
      const double growth = math::expm1(detail::smaller(x, 1));
      if (growth <= detail::series_until) {
        return growth / (1 + growth) * detail::meanLogGrowth(growth);
      }
      return x - 1 + math::exp(-x);
    }
  };

  KOKKOS_INLINE_FUNCTION Curve at(double alpha) const { return {a, shift(alpha)}; }

  // The alpha at which mu(V, alpha) = mu; V > 0, mu > 0.
  KOKKOS_INLINE_FUNCTION double stateFor(double V, double mu) const { return stateAt(V, mu / a); }
};
} // namespace asperity::friction
