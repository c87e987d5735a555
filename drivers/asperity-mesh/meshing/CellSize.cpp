#include "meshing/CellSize.hpp"

#include "arrangement/complex/Complex.hpp"
#include "surfaces/TriangleSurface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace asperity::geometry
{
void CellSize::addFault(TriangleSurface const& surface, Size size)
{
  double smallest = largest_;
  for (auto const& triangle : surface.triangles) {
    smallest = std::min(smallest, size(centroidOf(surface.points, triangle)));
    for (int v : triangle) {
      smallest = std::min(smallest, size(surface.points[v]));
    }
  }
  faults_.push_back({{surface.points, surface.triangles}, std::move(size), smallest});
}

void CellSize::addLimits(std::vector<std::pair<Point<3>, double>> const& limits)
{
  constexpr double steps = 2; // for each factor of 2
  std::map<int, TriangleSurface> by_size;
  for (auto const& [place, size] : limits) {
    auto& points = by_size[static_cast<int>(std::floor(steps * std::log2(size)))];
    const auto number = static_cast<int>(points.points.size());
    points.points.push_back(place);
    points.triangles.push_back({number, number, number});
  }
  for (auto const& [power, points] : by_size) {
    limits_.push_back({std::exp2(power / steps), {points.points, points.triangles}});
  }
}

namespace
{
constexpr double smallest_number = std::numeric_limits<double>::min(); // a distance may be 0
}

double CellSize::operator()(Point<3> const& place) const
{
  double size = largest_;
  // The distance beyond which a limit of this size cannot make the size smaller.
  const auto within = [&](double smallest) {
    return growth_ > 0 ? (size - smallest) / growth_ : std::numeric_limits<double>::infinity();
  };
  for (auto const& fault : faults_) {
    const double last = fault.tree.distance(fault.last, place) * (1 + 1e-12) + smallest_number;
    const auto nearest = fault.tree.nearest(place, std::min(last, within(fault.smallest)));
    if (nearest.triangle >= 0) {
      fault.last = nearest.triangle;
      size = std::min(size, fault.size(nearest.point) + growth_ * nearest.distance);
    }
  }
  for (auto const& limit : limits_) {
    const auto nearest =
      limit.size < size ? limit.tree.nearest(place, within(limit.size)) : TriangleTree::Nearest();
    if (nearest.triangle >= 0) {
      size = std::min(size, limit.size + growth_ * nearest.distance);
    }
  }
  return size;
}
} // namespace asperity::geometry
