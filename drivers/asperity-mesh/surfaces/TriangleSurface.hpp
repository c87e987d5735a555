#pragma once

#include <array>
#include <vector>

namespace asperity::geometry
{
// A triangulated surface in coordinates of the model [m]. Triangles are triples of indices into
// points.
struct TriangleSurface
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
};
} // namespace asperity::geometry
