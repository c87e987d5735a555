#include "arrangement/complex/Box.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace asperity::geometry
{
namespace
{
TriangleSurface rectangle(Point<3> const& a, Point<3> const& b, Point<3> const& c,
                          Point<3> const& d)
{
  return {{a, b, c, d}, {{0, 1, 2}, {0, 2, 3}}};
}

// The surface extends beyond the box, so that none of its borders lies on a wall.
TriangleSurface flatGround(Box const& box)
{
  const double more = 0.1 * std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  const double west = box.low[0] - more, east = box.high[0] + more;
  const double south = box.low[1] - more, north = box.high[1] + more;
  const double z = box.high[2];
  return rectangle({west, south, z}, {east, south, z}, {east, north, z}, {west, north, z});
}
} // namespace

Model makeModel(std::vector<NamedSurface> faults, TriangleSurface ground, Box const& box,
                BoxNames const& names)
{
  Model model;
  model.num_faults = static_cast<int>(faults.size());
  model.box = box;
  model.surfaces = std::move(faults);
  model.surfaces.push_back(
    {names.ground, ground.triangles.empty() ? flatGround(box) : std::move(ground)});
  double top = box.high[2];
  for (auto const& point : model.surfaces.back().surface.points) {
    top = std::max(top, point[2]);
  }
  top += 0.1 * (top - box.low[2]);
  const auto corner = [&](bool is_east, bool is_north, bool is_up) {
    return Point<3>{(is_east ? box.high : box.low)[0], (is_north ? box.high : box.low)[1],
                    is_up ? top : box.low[2]};
  };
  const auto wall = [&](std::string const& name, std::array<bool, 2> const& from,
                        std::array<bool, 2> const& to) {
    model.surfaces.push_back(
      {name, rectangle(corner(from[0], from[1], false), corner(to[0], to[1], false),
                       corner(to[0], to[1], true), corner(from[0], from[1], true))});
  };
  wall(names.west, {false, false}, {false, true});
  wall(names.east, {true, false}, {true, true});
  wall(names.south, {false, false}, {true, false});
  wall(names.north, {false, true}, {true, true});
  model.surfaces.push_back(
    {names.bottom, rectangle(corner(false, false, false), corner(true, false, false),
                             corner(true, true, false), corner(false, true, false))});
  return model;
}
} // namespace asperity::geometry
