#include "mesh/generation/WedgeMesh.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/generation/ExtrudedMesh.hpp"
#include "mesh/generation/PeriodicMesh.hpp"

#include <limits>

namespace asperity::mesh
{
namespace
{
using Interval = std::array<double, 2>;

void check(WedgeShape const& shape)
{
  requirePositive(shape.length, "Wedge / Length");
  requirePositive(shape.height, "Wedge / Height");
  requirePositive(shape.zone_width, "Wedge / Seismogenic Zone Width");
  requirePositive(shape.zone_end, "Wedge / Seismogenic Zone End");
  requirePositive(shape.cell_size, "Wedge / Cell Size");
  requirePositive(shape.growth_length, "Wedge / Growth Length");
  ASPERITY_REQUIRE(shape.growth_factor >= 0.0 && std::isfinite(shape.growth_factor),
                   "Mesh / Wedge / Growth Factor = " << shape.growth_factor
                                                     << " is outside [0, inf).");
  ASPERITY_REQUIRE(shape.zone_end <= shape.length,
                   "Mesh / Wedge / Seismogenic Zone End = "
                     << shape.zone_end << " is outside (0, Length = " << shape.length << "].");
  ASPERITY_REQUIRE(shape.zoneLeft() >= 0.0,
                   "Mesh / Wedge / Seismogenic Zone Width = "
                     << shape.zone_width
                     << " reaches beyond the trench: from its end to the trench "
                     << "there are " << shape.zoneRight() << " m.");
  ASPERITY_REQUIRE(shape.viscous_thickness >= 0.0 && shape.viscous_thickness <= shape.height,
                   "Mesh / Wedge / Viscous Thickness = "
                     << shape.viscous_thickness << " is outside [0, Height = " << shape.height
                     << "].");
  for (auto const& [low, high] : shape.further_zones) {
    ASPERITY_REQUIRE(low >= 0 && low < high && high <= shape.baseLength(),
                     "Mesh / Wedge / Refined Intervals: the interval from "
                       << low << " to " << high << " m does not lie on the base, which goes from 0 "
                       << "to " << shape.baseLength() << " m.");
  }
}

void check(DeepWedge const& deep)
{
  requirePositive(deep.depth, "Wedge / Depth");
  for (auto const& [low, high] : deep.patches) {
    ASPERITY_REQUIRE(low >= 0.0 && low < high && high <= deep.depth,
                     "Mesh / Deep Wedge / Seismogenic Intervals: the interval from "
                       << low << " to " << high << " m does not lie within the depth, from 0 to "
                       << deep.depth << " m.");
  }
}

// The whole wedge as one cell, of region `upper`.
GlobalMesh<2> wedgeTriangle(WedgeShape const& shape)
{
  const double base = shape.baseLength(), length = shape.length, height = shape.height;
  GlobalMesh<2> mesh;
  mesh.vertices = {{0.0, 0.0}, {base, 0.0}, {length * length / base, length * height / base}};
  mesh.cells = {{0, 1, 2}};
  mesh.cell_regions = {0};
  mesh.region_names = {"upper"};
  mesh.boundaries = {{"base", {{0, 1}}}, {"right", {{1, 2}}}, {"surface", {{2, 0}}}};
  return mesh;
}

// Regions `upper` and, if the viscous thickness is not zero, `lower` by the vertical depth of the
// cells' centroids below the surface.
template <int Dim>
void assignRegions(WedgeShape const& shape, GlobalMesh<Dim>& mesh)
{
  if (shape.viscous_thickness == 0.0) {
    return;
  }
  mesh.region_names = {"upper", "lower"};
  const auto down = shape.gravityDirection();
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto centre = centroid(corners(mesh, mesh.cells[c]));
    const double depth = dot<2>({centre[0], centre[1]}, down);
    mesh.cell_regions[c] = depth > shape.height - shape.viscous_thickness ? 1 : 0;
  }
}

double distanceToSegment(Point<2> const& p, Point<2> const& a, Point<2> const& b)
{
  const auto ab = difference<2>(b, a);
  const double along = dot<2>(difference<2>(p, a), ab) / dot<2>(ab, ab);
  const double t = std::clamp(along, 0.0, 1.0);
  return distance<2>(p, {a[0] + t * ab[0], a[1] + t * ab[1]});
}

// The seismogenic segment lies on the boundary of the wedge, not inside a cell, so that one of the
// nearest points is a corner of the cell or an end of the segment.
double distanceToZone(Triangle const& cell, Point<2> const& left, Point<2> const& right)
{
  double nearest = distanceToSegment(cell[0], left, right);
  for (int i = 0; i < 3; ++i) {
    auto const &a = cell[i], &b = cell[(i + 1) % 3];
    nearest = std::min({nearest, distanceToSegment(a, left, right), distanceToSegment(left, a, b),
                        distanceToSegment(right, a, b)});
  }
  return nearest;
}

// Prisms about half as long as the diameter of their triangles, and short enough for at least three
// layers if the mesh is periodic. Bisection preserves such shapes.
GlobalMesh<3> coarseWedge(WedgeShape const& shape, DeepWedge const& deep)
{
  const int fewest_layers = deep.is_periodic ? 3 : 1;
  const double size = 2.0 * std::min(deep.depth / fewest_layers, shape.height);
  const auto plane = bisect<2>(
    wedgeTriangle(shape), [=](Triangle const&) { return size; }, shape.limit);
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

double WedgeShape::angle() const { return std::atan(height / length); }

double WedgeShape::baseLength() const { return std::sqrt(length * length + height * height); }

double WedgeShape::zoneRight() const { return zone_end / std::cos(angle()); }

double WedgeShape::zoneLeft() const { return zoneRight() - zone_width; }

Point<2> WedgeShape::gravityDirection() const { return {std::sin(angle()), -std::cos(angle())}; }

GlobalMesh<2> wedgeMesh(WedgeShape const& shape)
{
  check(shape);
  auto zones = shape.further_zones;
  zones.push_back({shape.zoneLeft(), shape.zoneRight()});
  const double growth = shape.growth_factor / shape.growth_length;
  auto mesh = bisect<2>(
    wedgeTriangle(shape),
    [&](Triangle const& cell) {
      double nearest = std::numeric_limits<double>::infinity();
      for (auto const& [left, right] : zones) {
        nearest = std::min(nearest, distanceToZone(cell, {left, 0.0}, {right, 0.0}));
      }
      return (growth * nearest + 1.0) * shape.cell_size;
    },
    shape.limit);
  assignRegions(shape, mesh);
  return mesh;
}

GlobalMesh<3> deepWedgeMesh(WedgeShape const& shape, DeepWedge const& deep)
{
  check(shape);
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
  assignRegions(shape, mesh);
  return mesh;
}

GlobalMesh<3> layeredWedgeMesh(WedgeShape const& shape, double depth, int num_layers)
{
  requirePositive(depth, "Wedge / Depth");
  ASPERITY_REQUIRE(num_layers > 0,
                   "Mesh / Wedge / Layers = " << num_layers << " is outside [1, inf).");
  const auto plane = wedgeMesh(shape);
  requireFewVertices(static_cast<double>(plane.vertices.size()) * (num_layers + 1.0), shape.limit);
  return extrude(plane, equalLevels(depth, num_layers));
}
} // namespace asperity::mesh
