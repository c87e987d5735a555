#include "surfaces/DippingSurface.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::geometry
{
namespace
{
const double degree = std::acos(-1.) / 180;
using MapVector = std::array<double, 2>;

double cot(double degrees)
{
  return degrees == 90 ? 0 : std::cos(degrees * degree) / std::sin(degrees * degree);
}

MapVector alongAzimuth(double degrees)
{
  return {std::sin(degrees * degree), std::cos(degrees * degree)};
}

// To the right of each segment.
std::vector<MapVector> rightNormals(Polyline const& trace, std::string const& path)
{
  std::vector<MapVector> normals;
  for (std::size_t i = 0; i + 1 < trace.size(); ++i) {
    const double x = trace[i + 1][0] - trace[i][0], y = trace[i + 1][1] - trace[i][1];
    const double length = std::hypot(x, y);
    ASPERITY_REQUIRE(length > 0, path << ": points " << i + 1 << " and " << i + 2
                                      << " of the trace are at the same place.");
    normals.push_back({y / length, -x / length});
  }
  return normals;
}

// At a bend the offset that keeps the distance from both segments: (a + b) / (1 + a.b).
std::vector<MapVector> normalsAtPoints(DippingTrace const& given, std::string const& path)
{
  constexpr double sharpest = 0.5; // 1 + cos 120 degrees
  if (given.dip_direction) {
    return std::vector<MapVector>(given.trace.size(), alongAzimuth(*given.dip_direction));
  }
  const auto sides = rightNormals(given.trace, path);
  std::vector<MapVector> normals = {sides.front()};
  for (std::size_t i = 1; i < sides.size(); ++i) {
    auto const &a = sides[i - 1], &b = sides[i];
    const double cosine = a[0] * b[0] + a[1] * b[1];
    ASPERITY_REQUIRE(1 + cosine >= sharpest,
                     path << ": the trace turns by "
                          << formatShort(std::acos(std::clamp(cosine, -1., 1.)) / degree)
                          << " degrees at its point " << i + 1 << " "
                          << formatPoint({given.trace[i][0], given.trace[i][1]})
                          << "; at most 120 are possible. Smooth it, or give Dip Direction.");
    normals.push_back({(a[0] + b[0]) / (1 + cosine), (a[1] + b[1]) / (1 + cosine)});
  }
  normals.push_back(sides.back());
  return normals;
}

// The row of the surface at a given z.
Polyline rowAt(double z, DippingTrace const& given, std::vector<MapVector> const& normals)
{
  Polyline row;
  for (std::size_t i = 0; i < given.trace.size(); ++i) {
    auto const& p = given.trace[i];
    const double offset = (p[2] - z) * cot(given.dips[i]);
    row.push_back({p[0] + offset * normals[i][0], p[1] + offset * normals[i][1], z});
  }
  return row;
}

// The ruled surface between two rows, with points at most `spacing` apart.
TriangleSurface ruled(Polyline const& upper, Polyline const& lower, double spacing)
{
  constexpr double most = 1000;
  const auto pieces = [&](double length) {
    return static_cast<int>(std::clamp(std::ceil(length / spacing - 1e-9), 1., most));
  };
  Polyline upper_row = {upper.front()}, lower_row = {lower.front()};
  double width = distanceOf(upper.front(), lower.front());
  for (std::size_t i = 1; i < upper.size(); ++i) {
    const int count =
      pieces(std::max(distanceOf(upper[i - 1], upper[i]), distanceOf(lower[i - 1], lower[i])));
    for (int k = 1; k <= count; ++k) {
      upper_row.push_back(between(upper[i - 1], upper[i], double(k) / count));
      lower_row.push_back(between(lower[i - 1], lower[i], double(k) / count));
    }
    width = std::max(width, distanceOf(upper[i], lower[i]));
  }
  std::vector<Polyline> rows;
  const int num_rows = pieces(width);
  for (int j = 0; j <= num_rows; ++j) {
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < upper_row.size(); ++i) {
      row.push_back(between(upper_row[i], lower_row[i], double(j) / num_rows));
    }
  }
  return lofted(rows);
}

double widthOf(Polyline const& upper, Polyline const& lower)
{
  double width = 0;
  for (std::size_t i = 0; i < upper.size(); ++i) {
    width = std::max(width, distanceOf(upper[i], lower[i]));
  }
  return width;
}

constexpr double rows_by_default = 10;
} // namespace

TriangleSurface dippingSurface(DippingTrace const& given, std::string const& path)
{
  ASPERITY_REQUIRE(given.trace.size() >= 2, path << ": the trace has " << given.trace.size()
                                                 << " points; it needs two or more.");
  ASPERITY_ASSERT(given.dips.size() == given.trace.size());
  ASPERITY_REQUIRE(given.lower_z < given.upper_z,
                   path << ": the lower edge, z = " << formatShort(given.lower_z)
                        << " m, is not below the upper edge, z = " << formatShort(given.upper_z)
                        << " m.");
  const auto normals = normalsAtPoints(given, path);
  const auto upper = rowAt(given.upper_z, given, normals);
  const auto lower = rowAt(given.lower_z, given, normals);
  for (auto const* row : {&upper, &lower}) {
    const int folded = foldedSegment(given.trace, *row);
    ASPERITY_REQUIRE(folded < 0,
                     path << ": the surface is folded at z = " << formatShort(row->front()[2])
                          << " m, below or above points " << folded + 1 << " and " << folded + 2
                          << " of the trace, which bends too much for this dip. Smooth "
                             "the trace, or give Dip Direction.");
  }
  return ruled(upper, lower,
               given.spacing > 0 ? given.spacing : widthOf(upper, lower) / rows_by_default);
}

TriangleSurface planeSurface(PlaneShape const& shape)
{
  const auto along = alongAzimuth(shape.strike), right = alongAzimuth(shape.strike + 90);
  const double down = shape.width * std::sin(shape.dip * degree);
  const double across = shape.dip == 90 ? 0 : shape.width * std::cos(shape.dip * degree);
  Polyline upper, lower;
  for (const double side : {-0.5, 0.5}) {
    auto const& c = shape.top_centre;
    const double s = side * shape.length;
    upper.push_back({c[0] + s * along[0], c[1] + s * along[1], c[2]});
    lower.push_back(
      {upper.back()[0] + across * right[0], upper.back()[1] + across * right[1], c[2] - down});
  }
  return ruled(upper, lower, std::min(shape.length, shape.width) / rows_by_default);
}

PlaneShape extendedUp(PlaneShape const& shape, double z, std::string const& path)
{
  const double rise = z - shape.top_centre[2];
  if (rise <= 0) {
    return shape;
  }
  ASPERITY_REQUIRE(shape.dip > 0, path << ": a horizontal plane cannot go on up to the ground.");
  PlaneShape extended = shape;
  const auto right = alongAzimuth(shape.strike + 90);
  const double back = rise * cot(shape.dip);
  extended.top_centre = {shape.top_centre[0] - back * right[0],
                         shape.top_centre[1] - back * right[1], z};
  extended.width += rise / std::sin(shape.dip * degree);
  return extended;
}
} // namespace asperity::geometry
