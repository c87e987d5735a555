#include "mesh/generation/WedgeMesh.hpp"

#include "base/Errors.hpp"
#include "mesh/SimplexGeometry.hpp"
#include "mesh/generation/Bisection.hpp"
#include "mesh/generation/detail/WedgeParts.hpp"

#include <limits>

namespace asperity::mesh
{
namespace
{
void requirePositive(double value, char const* name)
{
  ASPERITY_REQUIRE(value > 0.0 && std::isfinite(value),
                   "Mesh / Wedge / " << name << " = " << value << " is outside (0, inf).");
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

} // namespace

namespace detail
{
void checkWedge(WedgeShape const& shape)
{
  requirePositive(shape.length, "Length");
  requirePositive(shape.height, "Height");
  requirePositive(shape.zone_width, "Seismogenic Zone Width");
  requirePositive(shape.zone_end, "Seismogenic Zone End");
  requirePositive(shape.cell_size, "Cell Size");
  requirePositive(shape.growth_length, "Growth Length");
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

template <int Dim>
void assignWedgeRegions(WedgeShape const& shape, GlobalMesh<Dim>& mesh)
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

template void assignWedgeRegions(WedgeShape const&, GlobalMesh<2>&);
template void assignWedgeRegions(WedgeShape const&, GlobalMesh<3>&);
} // namespace detail

double WedgeShape::angle() const { return std::atan(height / length); }

double WedgeShape::baseLength() const { return std::sqrt(length * length + height * height); }

double WedgeShape::zoneRight() const { return zone_end / std::cos(angle()); }

double WedgeShape::zoneLeft() const { return zoneRight() - zone_width; }

Point<2> WedgeShape::gravityDirection() const { return {std::sin(angle()), -std::cos(angle())}; }

GlobalMesh<2> wedgeMesh(WedgeShape const& shape)
{
  detail::checkWedge(shape);
  auto zones = shape.further_zones;
  zones.push_back({shape.zoneLeft(), shape.zoneRight()});
  const double growth = shape.growth_factor / shape.growth_length;
  auto mesh = bisect<2>(
    detail::wedgeTriangle(shape),
    [&](Triangle const& cell) {
      double nearest = std::numeric_limits<double>::infinity();
      for (auto const& [left, right] : zones) {
        nearest = std::min(nearest, distanceToZone(cell, {left, 0.0}, {right, 0.0}));
      }
      return (growth * nearest + 1.0) * shape.cell_size;
    },
    shape.limit);
  detail::assignWedgeRegions(shape, mesh);
  return mesh;
}
} // namespace asperity::mesh
