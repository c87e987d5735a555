#pragma once

#include "friction/laws/DirectEffect.hpp"

namespace asperity::friction
{
// mu(V, alpha) = a asinh(V / (2 V_alpha)), Pipping 2014, (5): smooth, linear far below V_alpha,
// a log(V / V_alpha) far above. Host and device; V >= 0 in m/s, any alpha.
struct RegularisedLaw : DirectEffect
{
  static constexpr char const* name = "Regularised";

  // The law at one state, a function of the slip rate alone. z = V / (2 V_alpha) = exp(x) / 2.
  struct Curve
  {
    double a;
    double shift;

    KOKKOS_INLINE_FUNCTION double logRatio(double V) const { return math::log(V) + shift; }

    KOKKOS_INLINE_FUNCTION double mu(double V) const
    {
      return a * detail::asinhHalfExp(logRatio(V));
    }

    // dmu/dV in s/m; infinite where the true value is beyond the largest double.
    KOKKOS_INLINE_FUNCTION double derivative(double V) const
    {
      const double x = logRatio(V);
      if (x > detail::asymptotic_from) {
        return a / V;
      }
      if (x > 0) {
        return a / (V * math::sqrt(1 + 4 * math::exp(-2 * x)));
      }
      return a * math::exp(shift) / math::sqrt(4 + math::exp(2 * x));
    }

    KOKKOS_INLINE_FUNCTION Response response(double V) const
    {
      const double x = logRatio(V);
      if (x > detail::asymptotic_from) {
        return {a * x, a, 0};
      }
      if (x > 0) {
        const double q = 4 * math::exp(-2 * x);
        const double root = math::sqrt(1 + q);
        return {a * (x + math::log1p(q / (2 * (1 + root)))), a / root, a * q / (root * (1 + q))};
      }
      const double z = math::exp(x) / 2;
      const double root = math::sqrt(1 + z * z);
      return {a * math::asinh(z), a * z / root, a * z / (root * (1 + z * z))};
    }

    // The average of mu between V and V + h, mu(V) for h = 0; V + h >= 0. Multiplied by h it is the
    // difference of mubar, accurate to the relative rounding of this difference.
    KOKKOS_INLINE_FUNCTION double mean(double V, double h) const;

    // The sum of the magnitudes of the terms of mu, including log V and shift, which may nearly
    // cancel; V > 0. Times the rounding unit it is the size of the errors of mu and mean.
    KOKKOS_INLINE_FUNCTION double terms(double V) const
    {
      const auto at = response(V);
      return at.mu + at.first * (math::fabs(math::log(V)) + math::fabs(shift));
    }

    KOKKOS_INLINE_FUNCTION bool kinkedAt(double) const { return false; }
  };

  KOKKOS_INLINE_FUNCTION Curve at(double alpha) const { return {a, shift(alpha)}; }

  // The alpha at which mu(V, alpha) = mu. The logarithm of V / V_alpha = 2 sinh(mu / a) is used,
  // since the hyperbolic sine overflows. V > 0, mu > 0.
  KOKKOS_INLINE_FUNCTION double stateFor(double V, double mu) const
  {
    const double y = mu / a;
    return stateAt(V, y + math::log(-math::expm1(-2 * y)));
  }
};

// With s = sqrt(1 + z^2) and integration by parts from the lower end,
//   mean / a = asinh z0 + (V1 / h) (asinh z1 - asinh z0) - (z0 + z1) / (s0 + s1),
//   asinh z1 - asinh z0 = asinh((z1^2 - z0^2) / (z1 s0 + z0 s1)).
// The cancellation between the last two terms is never large compared with the first term.
KOKKOS_INLINE_FUNCTION double RegularisedLaw::Curve::mean(double V, double h) const
{
  const double low = detail::larger(detail::smaller(V, V + h), 0);
  const double width = math::fabs(h);
  const double x0 = logRatio(low);
  if (x0 > detail::asymptotic_from) {
    return a * detail::meanLog(low, width, x0, logRatio(low + width));
  }
  const double asinh0 = detail::asinhHalfExp(x0);
  if (width == 0) {
    return a * asinh0;
  }
  const double z0 = math::exp(x0) / 2;
  const double s0 = math::sqrt(1 + z0 * z0);
  if (width <= low) {
    const double growth = width / low;
    const double z1 = z0 * (1 + growth);
    const double s1 = math::sqrt(1 + z1 * z1);
    const double sum = z0 + z1;
    const double rise = sum == 0 ? 0 : math::asinh(growth * z0 * sum / (z1 * s0 + z0 * s1));
    return a * (asinh0 + (1 + 1 / growth) * rise - sum / (s0 + s1));
  }
  // For z1 above exp(300) / 2 the last term is 1, and the bound keeps z1^2 from overflowing.
  const double x1 = logRatio(low + width);
  const double z1 = math::exp(detail::smaller(x1, 300)) / 2;
  const double s1 = math::sqrt(1 + z1 * z1);
  const double rise = detail::asinhHalfExp(x1) - asinh0;
  return a * (asinh0 + (1 + low / width) * rise - (z0 + z1) / (s0 + s1));
}
} // namespace asperity::friction
