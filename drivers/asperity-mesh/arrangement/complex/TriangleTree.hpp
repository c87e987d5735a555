#pragma once

#include "arrangement/complex/Complex.hpp"

#include <array>
#include <functional>
#include <limits>
#include <vector>

namespace asperity::geometry
{
// Finds the nearest point of many triangles, by a tree of their bounding boxes.
class TriangleTree
{
public:
  TriangleTree(std::vector<Point<3>> const& points, std::vector<Triangle> const& triangles);

  struct Nearest
  {
    int triangle = -1; // none within the bound
    Point<3> point{};
    double distance = std::numeric_limits<double>::infinity(); // [m]
  };
  // The nearest triangle within the bound among those that pass the filter, if there is a filter.
  using Filter = std::function<bool(int triangle)>;
  Nearest nearest(Point<3> const& place, double bound = std::numeric_limits<double>::infinity(),
                  Filter const& filter = {}) const;

  // The distance [m] of one triangle.
  double distance(int triangle, Point<3> const& place) const;

  // Whether the segment goes through a triangle.
  bool isCrossedBy(Point<3> const& from, Point<3> const& to) const;

private:
  struct Box
  {
    Point<3> low, high;
  };
  struct Node
  {
    Box box;
    int first, last;           // triangles, as in order_
    int left = -1, right = -1; // nodes; -1 in a leaf
  };
  int build(int first, int last);
  void search(int node, Point<3> const& place, Filter const& filter, Nearest& nearest) const;

  std::vector<std::array<Point<3>, 3>> corners_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};
} // namespace asperity::geometry
