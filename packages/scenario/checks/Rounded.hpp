#pragma once

#include "base/Text.hpp"

#include <cmath>
#include <string>

namespace asperity::scenario
{
// To three digits, for estimates.
inline std::string rounded(double value)
{
  const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
  return formatShort(std::round(value / unit) * unit);
}
} // namespace asperity::scenario
