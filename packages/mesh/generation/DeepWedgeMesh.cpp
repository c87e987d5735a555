#include "mesh/generation/DeepWedgeMesh.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/generation/Bisection.hpp"
#include "mesh/generation/ExtrudedMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"
#include "mesh/generation/detail/WedgeParts.hpp"

#include <cmath>
#include <limits>

namespace asperity::mesh
{
namespace
{
using Interval = std::array<double, 2>;

void checkDepth(double depth)
{
  ASPERITY_REQUIRE(depth > 0.0 && std::isfinite(depth),
                   "Mesh / Wedge / Depth = " << depth << " is outside (0, inf).");
}

void check(DeepWedge const& deep)
{
  checkDepth(deep.depth);
  for (auto const& [low, high] : deep.patches) {
    ASPERITY_REQUIRE(low >= 0.0 && low < high && high <= deep.depth,
                     "Mesh / Deep Wedge / Seismogenic Intervals: the interval from "
                       << low << " to " << high << " m does not lie within the depth, from 0 to "
                       << deep.depth << " m.");
  }
}

// Prisms about half as long as the diameter of their triangles, and short enough for at least three
// layers if the mesh is periodic. Bisection preserves such shapes.
GlobalMesh<3> coarseWedge(WedgeShape const& shape, DeepWedge const& deep)
{
  const int fewest_layers = deep.is_periodic ? 3 : 1;
  const double size = 2.0 * std::min(deep.depth / fewest_layers, shape.height);
  const auto plane = bisect<2>(
    detail::wedgeTriangle(shape), [=](Triangle const&) { return size; }, shape.limit);
  const double num_layers = std::round(2.0 * deep.depth / size);
  requireFewVertices((num_layers + 1) * static_cast<double>(plane.vertices.size()), shape.limit);
  auto mesh = extrude(plane, equalLevels(deep.depth, static_cast<int>(num_layers)));
  if (deep.is_periodic) {
    makePeriodic(mesh, 2, "front", "back");
  }
  return mesh;
}

// The rectangles of the base that are the seismogenic zone, and the strips of the further zones.
class SeismogenicZone
{
public:
  SeismogenicZone(WedgeShape const& shape, DeepWedge const& deep)
      : along_x_{shape.zoneLeft(), shape.zoneRight()}
      , strips_(shape.further_zones)
      , along_z_(deep.patches)
  {
    if (along_z_.empty()) {
      along_z_ = {{0.0, deep.depth}};
    }
    const std::size_t num_patches = along_z_.size();
    for (std::size_t i = 0; deep.is_periodic && i < num_patches; ++i) {
      const auto [low, high] = along_z_[i];
      along_z_.push_back({low - deep.depth, high - deep.depth});
      along_z_.push_back({low + deep.depth, high + deep.depth});
    }
  }

  double distanceToBoxOf(Tetrahedron const& cell) const
  {
    Point<3> low = cell[0], high = cell[0];
    for (auto const& corner : cell) {
      for (int d = 0; d < 3; ++d) {
        low[d] = std::min(low[d], corner[d]);
        high[d] = std::max(high[d], corner[d]);
      }
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (auto const& patch : along_z_) {
      nearest = std::min(nearest, gap({low[2], high[2]}, patch));
    }
    const Interval in_x = {low[0], high[0]};
    const double above = gap({low[1], high[1]}, {0.0, 0.0});
    double distance = std::hypot(gap(in_x, along_x_), above, nearest);
    for (auto const& strip : strips_) {
      distance = std::min(distance, std::hypot(gap(in_x, strip), above));
    }
    return distance;
  }

private:
  static double gap(Interval const& a, Interval const& b)
  {
    return std::max({a[0] - b[1], b[0] - a[1], 0.0});
  }

  Interval along_x_;
  std::vector<Interval> strips_; // over the whole depth
  std::vector<Interval> along_z_;
};
} // namespace

GlobalMesh<3> deepWedgeMesh(WedgeShape const& shape, DeepWedge const& deep)
{
  detail::checkWedge(shape);
  check(deep);
  const SeismogenicZone zone(shape, deep);
  const double growth = shape.growth_factor / shape.growth_length;
  constexpr double rounding = 1e-9;
  auto mesh = bisect<3>(
    coarseWedge(shape, deep),
    [&](Tetrahedron const& cell) {
      return (1.0 + rounding) * (growth * zone.distanceToBoxOf(cell) + 1.0) * shape.cell_size;
    },
    shape.limit);
  detail::assignWedgeRegions(shape, mesh);
  return mesh;
}

GlobalMesh<3> layeredWedgeMesh(WedgeShape const& shape, double depth, int num_layers)
{
  checkDepth(depth);
  ASPERITY_REQUIRE(num_layers > 0,
                   "Mesh / Wedge / Layers = " << num_layers << " is outside [1, inf).");
  const auto plane = wedgeMesh(shape);
  requireFewVertices(static_cast<double>(plane.vertices.size()) * (num_layers + 1.0), shape.limit);
  return extrude(plane, equalLevels(depth, num_layers));
}
} // namespace asperity::mesh
