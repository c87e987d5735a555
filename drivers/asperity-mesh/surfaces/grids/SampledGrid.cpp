#include "surfaces/grids/SampledGrid.hpp"

#include "surfaces/Lofting.hpp"
#include "surfaces/TriangleSurface.hpp"
#include "surfaces/kinds/SurfaceKinds.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace asperity::geometry
{
namespace
{
// The smaller spacing of the two axes in the middle of the grid, in the model [m].
double spacingOf(Grid const& grid, Units const& units)
{
  const std::size_t i = (grid.x().size() - 1) / 2, j = (grid.y().size() - 1) / 2;
  Polyline places = {{grid.x()[i], grid.y()[j], 0},
                     {grid.x()[i + 1], grid.y()[j], 0},
                     {grid.x()[i], grid.y()[j + 1], 0}};
  units.toModel(places);
  return std::min(distanceOf(places[0], places[1]), distanceOf(places[0], places[2]));
}
} // namespace

TriangleSurface surfaceOf(Grid const& grid, Units const& units, double step)
{
  const double spacing = spacingOf(grid, units);
  const double stride = std::clamp(std::ceil(step / spacing - 1e-6), 1., 1e6);
  auto surface = grid.surface(static_cast<std::size_t>(stride));
  units.toModel(surface.points);
  return surface;
}

TriangleSurface groundOf(Grid const& grid, Units const& units, MapArea const& area, double step,
                         Outside outside)
{
  constexpr double most = 1e7;
  const double spacing = step > 0 ? step : spacingOf(grid, units);
  std::array<double, 2> count{};
  for (std::size_t d = 0; d < 2; ++d) {
    ASPERITY_REQUIRE(area.high[d] > area.low[d], grid.where() << ": the area of the ground is "
                                                                 "empty.");
    count[d] = std::max(1., std::ceil((area.high[d] - area.low[d]) / spacing - 1e-9));
  }
  ASPERITY_REQUIRE(count[0] * count[1] <= most,
                   grid.where() << ": the ground would have " << formatShort(count[0] * count[1])
                                << " points, more than 1e7, at a distance of "
                                << formatShort(spacing) << " m. Give a larger Step.");
  std::vector<Polyline> rows;
  for (int j = 0; j <= static_cast<int>(count[1]); ++j) {
    auto& row = rows.emplace_back();
    for (int i = 0; i <= static_cast<int>(count[0]); ++i) {
      row.push_back({area.low[0] + i / count[0] * (area.high[0] - area.low[0]),
                     area.low[1] + j / count[1] * (area.high[1] - area.low[1]), 0});
    }
    auto places = row;
    units.fromModel(places);
    for (std::size_t i = 0; i < row.size(); ++i) {
      row[i][2] = grid(places[i][0], places[i][1], outside);
    }
  }
  return lofted(rows);
}
} // namespace asperity::geometry
