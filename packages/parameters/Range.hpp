#pragma once

#include <cmath>
#include <limits>
#include <string>

namespace asperity
{
// The values a number may take. An infinite end is always open; NaN is in no range, not even in
// any().
class Range
{
public:
  // has_lower, has_upper: whether the bound itself belongs to the range.
  Range(double lower, bool has_lower, double upper, bool has_upper)
      : lower_(lower)
      , upper_(upper)
      , has_lower_(has_lower && std::isfinite(lower))
      , has_upper_(has_upper && std::isfinite(upper))
  {
  }

  static Range any() { return Range(-infinity(), false, infinity(), false); }
  static Range positive() { return above(0.0); }
  static Range atLeast(double lower) { return Range(lower, true, infinity(), false); }
  static Range above(double lower) { return Range(lower, false, infinity(), false); }
  static Range below(double upper) { return Range(-infinity(), false, upper, false); }
  static Range closed(double lower, double upper) { return Range(lower, true, upper, true); }
  static Range open(double lower, double upper) { return Range(lower, false, upper, false); }
  static Range openClosed(double lower, double upper) { return Range(lower, false, upper, true); }
  static Range closedOpen(double lower, double upper) { return Range(lower, true, upper, false); }

  bool contains(double value) const;

  bool isEmpty() const;
  Range intersection(Range const& other) const;

  // "(0, inf)", "[0, 0.5]"
  std::string text() const;

private:
  static constexpr double infinity() { return std::numeric_limits<double>::infinity(); }

  double lower_, upper_;
  bool has_lower_, has_upper_;
};
} // namespace asperity
