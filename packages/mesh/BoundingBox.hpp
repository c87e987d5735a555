#pragma once

#include "base/parallel/Reductions.hpp"
#include "mesh/Mesh.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace asperity::mesh
{
// The sides [m] of the smallest box along the axes around the points of all ranks; -infinity if
// there are none. Collective.
template <int Dim>
Point<Dim> sidesOfBox(std::vector<Point<Dim>> const& points, Communicator const& communicator)
{
  Point<2 * Dim> ends; // -lowest, highest
  ends.fill(-std::numeric_limits<double>::infinity());
  for (auto const& point : points) {
    for (int d = 0; d < Dim; ++d) {
      ends[d] = std::max(ends[d], -point[d]);
      ends[Dim + d] = std::max(ends[Dim + d], point[d]);
    }
  }
  ends = maxOverRanks(ends, communicator);
  Point<Dim> sides;
  for (int d = 0; d < Dim; ++d) {
    sides[d] = ends[Dim + d] + ends[d];
  }
  return sides;
}
} // namespace asperity::mesh
