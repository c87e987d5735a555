#pragma once

#include "mesh/SimplexGeometry.hpp"

#include <cmath>
#include <map>

namespace asperity::mesh::detail
{
// Finds points by their coordinates, up to a tolerance.
template <int Dim>
class PointTable
{
public:
  PointTable(std::vector<Point<Dim>> const& vertices, std::vector<int> const& chosen,
             double tolerance)
      : vertices_(vertices)
      , tolerance_(tolerance)
  {
    for (int vertex : chosen) {
      numbers_.emplace(boxOf(vertices[vertex]), vertex);
    }
  }

  // The chosen vertex at this point, or -1.
  int find(Point<Dim> const& point) const
  {
    int found = -1;
    visitBoxes(0, point, boxOf(point), found);
    return found;
  }

private:
  using Box = std::array<long long, Dim>;

  Box boxOf(Point<Dim> const& point) const
  {
    Box box;
    for (int d = 0; d < Dim; ++d) {
      box[d] = std::llround(point[d] / (2.0 * tolerance_));
    }
    return box;
  }

  // A point within the tolerance lies in the same box or in one beside it.
  void visitBoxes(int axis, Point<Dim> const& point, Box box, int& found) const
  {
    if (axis == Dim) {
      const auto [first, last] = numbers_.equal_range(box);
      for (auto entry = first; entry != last; ++entry) {
        if (distance<Dim>(vertices_[entry->second], point) <= tolerance_) {
          found = entry->second;
        }
      }
      return;
    }
    const long long middle = box[axis];
    for (long long beside = middle - 1; beside <= middle + 1; ++beside) {
      box[axis] = beside;
      visitBoxes(axis + 1, point, box, found);
    }
  }

  std::vector<Point<Dim>> const& vertices_;
  double tolerance_;
  std::multimap<Box, int> numbers_;
};
} // namespace asperity::mesh::detail
