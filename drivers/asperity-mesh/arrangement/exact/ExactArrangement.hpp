#pragma once

#include "arrangement/complex/Complex.hpp"

#include <vector>

namespace asperity::geometry
{
struct Arrangement
{
  Complex complex; // of all triangles, whether inside the box or not
  // (num_surfaces) x (its points): the point of the complex; -1 where no triangle is at the point
  std::vector<std::vector<int>> points_of;
};

// Divides the triangles of surfaces where these meet, so that they have vertices and edges in
// common there. Computes with rational numbers (CGAL), without a tolerance, and rounds at the end.
// Surfaces are as checkedSurface makes them.
//
// InputError, with names and place, if two surfaces overlap in an area, or a surface crosses,
// touches or overlaps itself.
Arrangement arrange(std::vector<NamedSurface> const& surfaces);
} // namespace asperity::geometry
