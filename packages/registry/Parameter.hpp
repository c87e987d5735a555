#pragma once

#include "registry/Range.hpp"

#include <cmath>
#include <limits>

namespace asperity
{
inline constexpr double no_default = std::numeric_limits<double>::quiet_NaN();

// One row of a law's table: what a deck may say and what the documentation prints.
struct Parameter
{
  char const* name;
  char const* unit;
  double default_value; // no_default: the parameter has to be given
  Range range;
  char const* meaning;   // one sentence
  char const* hint = ""; // what to try when a value is refused

  bool required() const { return std::isnan(default_value); }
};
} // namespace asperity
