#include "surfaces/kinds/Units.hpp"

#include "base/Errors.hpp"

#include <algorithm>

namespace asperity::geometry
{
namespace
{
constexpr char const* units_name = "Units";
constexpr char const* depth_units_name = "Depth Units";
constexpr char const* as_units = "as Units";
} // namespace

double lengthUnit(std::string const& word) { return word == "km" ? 1000 : 1; }

Units::Units(std::string const& horizontal, double vertical, std::string const& path,
             SurfaceContext const& context)
    : horizontal_(lengthUnit(horizontal))
    , vertical_(vertical)
    , are_degrees_(horizontal == "degrees")
    , projection_(context.projection)
    , origin_(context.origin)
{
  ASPERITY_REQUIRE(!are_degrees_ || projection_ != nullptr,
                   path << " is given in degrees of longitude and latitude, but there is no "
                           "projection. Give Projection, as 'utm11' or 'EPSG:32611'.");
}

Declare& Units::declare(Declare& declare)
{
  return declare
    .choice(units_name, required, {"m", "km", "degrees"},
            "Says in which unit x and y are given; degrees are longitude and latitude, which the "
            "projection takes to metres.")
    .choice(depth_units_name, as_units, {as_units, "m", "km"},
            "Says in which unit z or the depth is given; with Units = degrees it is needed where a "
            "file has depths.");
}

Units Units::read(ParameterList const& list, std::string const& path, SurfaceContext const& context)
{
  auto const& horizontal = list.get<std::string>(units_name);
  auto const& depth = list.get<std::string>(depth_units_name);
  ASPERITY_REQUIRE(horizontal != "degrees" || depth != as_units,
                   joinPath(path, depth_units_name)
                     << " is missing: x and y are in degrees, and z is in m or km.");
  return {horizontal, lengthUnit(depth == as_units ? horizontal : depth), path, context};
}

void Units::toModel(Polyline& points) const
{
  if (are_degrees_) {
    projection_->toPlane(points);
  }
  for (auto& point : points) {
    point = {horizontal_ * point[0] - origin_[0], horizontal_ * point[1] - origin_[1],
             vertical_ * point[2]};
  }
}

void Units::fromModel(Polyline& points) const
{
  for (auto& point : points) {
    point = {(point[0] + origin_[0]) / horizontal_, (point[1] + origin_[1]) / horizontal_,
             point[2]};
  }
  if (are_degrees_) {
    projection_->toGeographic(points);
  }
}

std::string fileOf(ParameterList const& list, std::string const& name,
                   SurfaceContext const& context)
{
  return (context.folder / list.get<std::string>(name)).string();
}

double aboveGround(double lower_z, SurfaceContext const& context)
{
  constexpr double margin = 0.05; // of the height
  return context.highest_ground + margin * std::max(0., context.highest_ground - lower_z);
}

Declare& declareExtendUp(Declare& declare, bool value)
{
  return declare.boolean("Extend Up", value,
                         "If true, the surface goes on up dip beyond the ground, which cuts it.");
}
} // namespace asperity::geometry
