#include "meshing/Features.hpp"

#include "arrangement/complex/Complex.hpp"
#include "arrangement/complex/Curves.hpp"
#include "arrangement/complex/Patches.hpp"
#include "arrangement/complex/TriangleTree.hpp"

#include "mesh/SimplexGeometry.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace asperity::geometry
{
namespace
{
class Narrowness
{
public:
  Narrowness(Complex const& complex, CellSize const& size)
      : complex_(complex)
      , size_(size)
      , curves_(findCurves(complex))
      , patches_(findPatches(complex))
      , surfaces_(complex.points, complex.triangles)
      , segments_({}, {})
      , patches_at_(complex.points.size())
  {
    std::vector<Triangle> segments;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      auto const& points = curves_[c].points;
      for (std::size_t i = 1; i < points.size(); ++i) {
        segments.push_back({points[i - 1], points[i], points[i]});
        curve_of_.push_back(static_cast<int>(c));
      }
      curves_at_[points.front()].insert(static_cast<int>(c));
      curves_at_[points.back()].insert(static_cast<int>(c));
    }
    segments_ = TriangleTree(complex.points, segments);
    for (std::size_t i = 0; i < complex.triangles.size(); ++i) {
      for (int v : complex.triangles[i]) {
        patches_at_[v].insert(patches_.patch_of_triangle[i]);
      }
    }
  }

  std::vector<std::pair<Point<3>, double>> run(double smallest_share) const
  {
    std::vector<std::pair<Point<3>, double>> found;
    for (auto const& curve : curves_) {
      std::set<int> own_curves, own_patches;
      for (int v : {curve.points.front(), curve.points.back()}) {
        auto const& curves = curves_at_.at(v);
        own_curves.insert(curves.begin(), curves.end());
      }
      for (int v : curve.points) {
        own_patches.insert(patches_at_[v].begin(), patches_at_[v].end());
      }
      for (auto const& place : samples(curve)) {
        const double size = size_(place);
        const auto other = segments_.nearest(
          place, size, [&](int i) { return own_curves.count(curve_of_[i]) == 0; });
        const auto patch = surfaces_.nearest(place, std::min(size, other.distance), [&](int i) {
          return own_patches.count(patches_.patch_of_triangle[i]) == 0;
        });
        const double distance = std::min(other.distance, patch.distance);
        if (distance < size) {
          found.emplace_back(place, std::max(distance, smallest_share * size));
        }
      }
    }
    return found;
  }

private:
  // Points on a curve, at most half a cell apart.
  std::vector<Point<3>> samples(Curve const& curve) const
  {
    std::vector<Point<3>> places;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      auto const& a = complex_.points[curve.points[i - 1]];
      auto const& b = complex_.points[curve.points[i]];
      const double length = mesh::distance<3>(a, b);
      const double step = 0.5 * std::min(size_(a), size_(b));
      const int number = 1 + static_cast<int>(length / step);
      for (int k = 0; k <= number; ++k) {
        auto& place = places.emplace_back();
        for (int d = 0; d < 3; ++d) {
          place[d] = a[d] + (b[d] - a[d]) * k / number;
        }
      }
    }
    return places;
  }

  Complex const& complex_;
  CellSize const& size_;
  std::vector<Curve> curves_;
  Patches patches_;
  TriangleTree surfaces_, segments_;
  std::vector<int> curve_of_;              // (num_segments)
  std::map<int, std::set<int>> curves_at_; // by corner
  std::vector<std::set<int>> patches_at_;  // (num_points)
};
} // namespace

std::vector<std::pair<Point<3>, double>> narrowPlaces(Complex const& complex, CellSize const& size,
                                                      double smallest_share)
{
  return Narrowness(complex, size).run(smallest_share);
}
} // namespace asperity::geometry
