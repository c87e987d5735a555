#pragma once

#include <cmath>

namespace asperity::tnnmg
{
// Finds the step along a direction at which the derivative of a convex function changes sign.
//
// slope(t) is the function's derivative along the direction at step t (one-sided at a jump); it
// must not decrease. start = slope(0); the step is zero unless start < 0. The search stops where
// |slope| <= tolerance |start|, at the largest step if the slope is still negative there, or where
// the bracket cannot shrink. In the last case it returns the end to the left of the sign change, up
// to which the function decreases.
template <class Slope>
double findSignChange(Slope const& slope, double start, double tolerance,
                      double largest_step = 1024)
{
  if (!(start < 0)) {
    return 0;
  }
  const double small = tolerance * std::abs(start);
  double left = 0;
  double slope_left = start;
  double right = largest_step < 1 ? largest_step : 1;
  double slope_right = slope(right);
  while (slope_right < -small && right < largest_step) {
    left = right;
    slope_left = slope_right;
    right *= 2;
    slope_right = slope(right);
  }
  if (slope_right <= small) {
    return right;
  }
  int stalled = 0;
  for (int iteration = 0; iteration < 80 && right - left > 1e-14 * right; ++iteration) {
    // Regula falsi that halves the slope at an end that stays (Illinois), and bisection when regula
    // falsi stalls.
    double middle = (left * slope_right - right * slope_left) / (slope_right - slope_left);
    if (stalled > 3 || !(middle > left && middle < right)) {
      middle = (left + right) / 2;
      stalled = 0;
    }
    const double value = slope(middle);
    if (std::abs(value) <= small) {
      return middle;
    }
    const double width = right - left;
    if (value < 0) {
      left = middle;
      slope_left = value;
      slope_right /= 2;
    } else {
      right = middle;
      slope_right = value;
      slope_left /= 2;
    }
    stalled = right - left > width / 2 ? stalled + 1 : 0;
  }
  return left;
}
} // namespace asperity::tnnmg
