#pragma once

#include <array>
#include <cmath>

namespace asperity::fem
{
// A boundary is steep if its tangent has at most this part along x.
inline constexpr double steep = 0.4;

// In two dimensions: the tangent that the frames have on a boundary with this unit normal, of
// either sign. It points along +x, or along +y if the boundary is steep.
inline std::array<double, 2> tangentInPlane(double normal_x, double normal_y)
{
  if (std::abs(normal_y) > steep) {
    return {std::abs(normal_y), normal_y > 0 ? -normal_x : normal_x};
  }
  return {normal_x > 0 ? -normal_y : normal_y, std::abs(normal_x)};
}
} // namespace asperity::fem
