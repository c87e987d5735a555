#pragma once

#include "portability/Renamed.hpp"

#include <Kokkos_Core.hpp>

#include <limits>

// Functions that the laws share, on host and device. All quantities are dimensionless.
namespace asperity::friction
{
namespace math = asperity::math; // for laws, those of plugins too

namespace detail
{
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

// For x above this, 1 + exp(-2 x) is rounded to 1.
inline constexpr double asymptotic_from = 20;

KOKKOS_INLINE_FUNCTION double smaller(double x, double y) { return x < y ? x : y; }
KOKKOS_INLINE_FUNCTION double larger(double x, double y) { return x < y ? y : x; }

// False for infinities and NaN.
KOKKOS_INLINE_FUNCTION bool isFinite(double x) { return x - x == 0; }

// asinh(exp(x) / 2) for every x in [-inf, inf].
KOKKOS_INLINE_FUNCTION double asinhHalfExp(double x)
{
  if (x > asymptotic_from) {
    return x;
  }
  if (x > 0) {
    const double q = 4 * math::exp(-2 * x);
    return x + math::log1p(q / (2 * (1 + math::sqrt(1 + q))));
  }
  return math::asinh(math::exp(x) / 2);
}

// Largest u for which meanLogGrowth sums its series.
inline constexpr double series_until = 0.65;

// The average of log(1 + s) over s in [0, u]: (1 + u) log(1 + u) / u - 1, for 0 <= u <=
// series_until. As a series in t = u / (2 + u), where log(1 + u) = 2 artanh t, all its terms are
// positive, so that nothing cancels.
KOKKOS_INLINE_FUNCTION double meanLogGrowth(double u)
{
  const double t = u / (2 + u);
  const double t2 = t * t;
  double sum = 0; // of t^(2k) / (2k + 3)
  for (int k = 13; k >= 0; --k) {
    sum = sum * t2 + 1.0 / (2 * k + 3);
  }
  return t + (1 + t) * t2 * sum;
}

// The average of x(V) = log(V / V_alpha) over V in [low, low + width]; low > 0, width >= 0; x0 and
// x1 are the values at both ends. Where x0 >= 0, it is accurate to the rounding of the average.
KOKKOS_INLINE_FUNCTION double meanLog(double low, double width, double x0, double x1)
{
  if (width <= series_until * low) {
    return x0 + meanLogGrowth(width / low);
  }
  return x0 + (1 + low / width) * (x1 - x0) - 1;
}
} // namespace detail
} // namespace asperity::friction
