#pragma once

#include "friction/laws/DirectEffect.hpp"

namespace asperity::friction
{
// The regularised law (Rice & Ben-Zion 1996; Pipping 2014, equation 5),
//
//   mu(V, alpha) = a asinh(V / (2 V_alpha)),
//
// with the slip rate V >= 0 [m/s], the state alpha [-], and a [-] and V_alpha [m/s] of
// DirectEffect. It is smooth, linear in V far below V_alpha, and a ln(V / V_alpha) far above. Host
// and device; alpha may have any value.
struct RegularisedLaw : DirectEffect
{
  static constexpr char const* name = "Regularised";

  // The law at one state, a function of the slip rate alone: mu(V) = a asinh(z) with
  // z = V / (2 V_alpha) = exp(x) / 2 and x(V) = ln(V / V_alpha).
  struct Curve
  {
    double a;
    double shift; // -ln(V_alpha s/m)

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

    // The average of mu between V and V + h, mu(V) for h = 0; V + h >= 0. Multiplied by h it is
    // the difference of mubar, the integral of mu, accurate to the relative rounding of this
    // difference.
    KOKKOS_INLINE_FUNCTION double mean(double V, double h) const;

    // The sum of the magnitudes of the terms of mu, including ln V and shift, which may nearly
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

// V0 < V1 are the two ends, h = V1 - V0, z0 and z1 the values of z there, and s = sqrt(1 + z^2).
// Integration by parts gives
//
//   mean / a = asinh z0 + (V1 / h) (asinh z1 - asinh z0) - (z0 + z1) / (s0 + s1),
//   asinh z1 - asinh z0 = asinh((z1^2 - z0^2) / (z1 s0 + z0 s1)).
//
// What the last two terms of the first line lose by cancellation is never large compared with its
// first term.
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
