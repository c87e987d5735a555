#pragma once

#include "arrangement/complex/TriangleTree.hpp"
#include "surfaces/TriangleSurface.hpp"

#include "mesh/Mesh.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace asperity::geometry
{
// The size [m] that cells are to have at a place:
//
//   min(largest, size_f(y) + growth |x - y|, s_i + growth |x - x_i|)
//
// with y the point of fault f nearest to x, over all faults f and all limits (x_i, s_i).
class CellSize
{
public:
  using Size = std::function<double(Point<3> const&)>;

  CellSize(double growth, double largest) : growth_(growth), largest_(largest) {}

  void addFault(TriangleSurface const& surface, Size size);
  void addLimits(std::vector<std::pair<Point<3>, double>> const& limits);

  double operator()(Point<3> const& place) const;
  double growth() const { return growth_; }

private:
  struct Fault
  {
    TriangleTree tree;
    Size size;
    double smallest;      // at its points and centroids
    mutable int last = 0; // the triangle found last: places of calls follow each other
  };
  // Limits by equal sizes, rounded down to powers of 2^(1/2), so that a tree finds the nearest.
  struct Limits
  {
    double size;
    TriangleTree tree;
  };

  double growth_, largest_;
  std::vector<Fault> faults_;
  std::vector<Limits> limits_;
};
} // namespace asperity::geometry
