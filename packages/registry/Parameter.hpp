#pragma once

#include <cmath>
#include <limits>

namespace asperity
{
// One row of a law's table: what a deck may say and what the documentation prints.
struct Parameter
{
  char const* name;
  char const* unit;
  double default_value; // NaN: the parameter has to be given
  double lower;
  double upper;
  bool lower_closed; // whether the bound itself is allowed
  bool upper_closed;
  char const* meaning;   // one sentence
  char const* hint = ""; // what to try when a value is refused

  bool required() const { return std::isnan(default_value); }
};

inline constexpr double no_default = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
} // namespace asperity
