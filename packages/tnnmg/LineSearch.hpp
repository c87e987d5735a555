#pragma once

#include <cmath>

namespace asperity::tnnmg
{
struct LineSearchResult
{
  double step = 0;
  int evaluations = 0;
};

// Finds the step along a direction at which the derivative of a convex function changes sign.
//
// slope(t) is the function's derivative along the direction at step t (one-sided at a jump); it
// must not decrease. start = slope(0); the step is zero unless start < 0. The search stops where
// |slope| <= tolerance |start|, at step 1024 if the slope is still negative there, or where the
// bracket cannot shrink. In the last case it returns the end to the left of the sign change, up to
// which the function decreases.
template <class Slope>
LineSearchResult findSignChange(Slope const& slope, double start, double tolerance)
{
  LineSearchResult result;
  if (!(start < 0)) {
    return result;
  }
  const double small = tolerance * std::abs(start);
  double left = 0;
  double slope_left = start;
  double right = 1;
  double slope_right = slope(right);
  result.evaluations = 1;
  while (slope_right < -small && right < 1024) {
    left = right;
    slope_left = slope_right;
    right *= 2;
    slope_right = slope(right);
    ++result.evaluations;
  }
  if (slope_right <= small) {
    result.step = right;
    return result;
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
    ++result.evaluations;
    if (std::abs(value) <= small) {
      result.step = middle;
      return result;
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
  result.step = left;
  return result;
}
} // namespace asperity::tnnmg
