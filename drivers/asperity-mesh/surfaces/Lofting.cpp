#include "surfaces/Lofting.hpp"

#include "base/Errors.hpp"

#include <algorithm>
#include <cmath>

namespace asperity::geometry
{
double distanceOf(SpacePoint const& a, SpacePoint const& b)
{
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

SpacePoint between(SpacePoint const& a, SpacePoint const& b, double share)
{
  SpacePoint point;
  for (std::size_t d = 0; d < 3; ++d) {
    point[d] = share == 1 ? b[d] : a[d] + share * (b[d] - a[d]);
  }
  return point;
}

double lengthOf(Polyline const& line)
{
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += distanceOf(line[i - 1], line[i]);
  }
  return length;
}

Polyline resampled(Polyline const& line, int num_segments)
{
  ASPERITY_ASSERT(line.size() >= 2 && num_segments >= 1);
  const double step = lengthOf(line) / num_segments;
  Polyline result = {line.front()};
  std::size_t segment = 1;
  double before = 0; // arc length at the beginning of the segment
  double length = distanceOf(line[0], line[1]);
  for (int i = 1; i < num_segments; ++i) {
    while (before + length < i * step && segment + 1 < line.size()) {
      before += length;
      ++segment;
      length = distanceOf(line[segment - 1], line[segment]);
    }
    const double share = length > 0 ? std::min(1., (i * step - before) / length) : 0;
    result.push_back(between(line[segment - 1], line[segment], share));
  }
  result.push_back(line.back());
  return result;
}

TriangleSurface lofted(std::vector<Polyline> const& rows)
{
  TriangleSurface surface;
  for (auto const& row : rows) {
    ASPERITY_ASSERT(row.size() == rows.front().size());
    surface.points.insert(surface.points.end(), row.begin(), row.end());
  }
  const int width = static_cast<int>(rows.front().size());
  for (int j = 0; j + 1 < static_cast<int>(rows.size()); ++j) {
    for (int i = 0; i + 1 < width; ++i) {
      const int a = j * width + i, b = a + 1, c = b + width, d = a + width;
      const auto at = [&](int v) -> auto const&
      {
        return surface.points[static_cast<std::size_t>(v)];
      };
      if (distanceOf(at(a), at(c)) <= distanceOf(at(b), at(d))) {
        surface.triangles.push_back({a, b, c});
        surface.triangles.push_back({a, c, d});
      } else {
        surface.triangles.push_back({a, b, d});
        surface.triangles.push_back({b, c, d});
      }
    }
  }
  return surface;
}

int foldedSegment(Polyline const& row, Polyline const& other)
{
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    const double along = (row[i + 1][0] - row[i][0]) * (other[i + 1][0] - other[i][0]) +
                         (row[i + 1][1] - row[i][1]) * (other[i + 1][1] - other[i][1]);
    if (!(along > 0)) {
      return static_cast<int>(i);
    }
  }
  return -1;
}
} // namespace asperity::geometry
