#pragma once

#include <cmath>
#include <limits>

namespace asperity
{
inline constexpr double no_default = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

// Between which bounds the values of a parameter lie, and whether a bound itself is allowed. The
// names are those of Range (parameters/Range.hpp), which a table that is a constant cannot use.
class Bounds
{
public:
  static constexpr Bounds positive() { return above(0); }
  static constexpr Bounds atLeast(double lower) { return {lower, true, infinity, false}; }
  static constexpr Bounds above(double lower) { return {lower, false, infinity, false}; }
  static constexpr Bounds closed(double lower, double upper) { return {lower, true, upper, true}; }
  static constexpr Bounds openClosed(double lower, double upper)
  {
    return {lower, false, upper, true};
  }
  static constexpr Bounds closedOpen(double lower, double upper)
  {
    return {lower, true, upper, false};
  }

  constexpr double lower() const { return lower_; }
  constexpr double upper() const { return upper_; }
  constexpr bool hasLower() const { return has_lower_; }
  constexpr bool hasUpper() const { return has_upper_; }

private:
  constexpr Bounds(double lower, bool has_lower, double upper, bool has_upper)
      : lower_(lower)
      , upper_(upper)
      , has_lower_(has_lower)
      , has_upper_(has_upper)
  {
  }

  double lower_, upper_;
  bool has_lower_, has_upper_;
};

// One row of a law's table: what a deck may say and what the documentation prints.
struct Parameter
{
  char const* name;
  char const* unit;
  double default_value; // no_default: the parameter has to be given
  Bounds bounds;
  char const* meaning;   // one sentence
  char const* hint = ""; // what to try when a value is refused

  bool required() const { return std::isnan(default_value); }
};
} // namespace asperity
