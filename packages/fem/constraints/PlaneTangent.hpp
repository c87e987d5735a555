#pragma once

#include <array>
#include <cmath>

namespace asperity::fem
{
// An axis completes a basis if a larger part of it than this lies outside the span of what is
// there.
inline constexpr double least_remainder = 0.4;

// In two dimensions: the tangent of a plane boundary with this unit normal, of either sign. It
// points along +x, or along +y if x has too small a part along it. On a bent fault all nodes have
// the sense of the tangent for the mean normal.
inline std::array<double, 2> tangentInPlane(double normal_x, double normal_y)
{
  if (std::abs(normal_y) > least_remainder) {
    return {std::abs(normal_y), normal_y > 0 ? -normal_x : normal_x};
  }
  return {normal_x > 0 ? -normal_y : normal_y, std::abs(normal_x)};
}
} // namespace asperity::fem
