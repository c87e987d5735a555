#include "surfaces/DippingSurface.hpp"
#include "surfaces/Lofting.hpp"
#include "surfaces/kinds/SurfaceKind.hpp"
#include "surfaces/kinds/Units.hpp"

#include "base/Errors.hpp"
#include "parameters/Entries.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace asperity::geometry
{
namespace
{
constexpr char const* top_centre = "Top Centre";

Entries<PlaneShape> planeEntries()
{
  Entries<PlaneShape> entries;
  entries.others().realArray(top_centre, required, "m, km or deg", Range::any(),
                             "The middle of the upper edge lies at these x and y, and at the z "
                             "that follows, in m with Units = degrees; without it at 0.");
  entries
    .real("Strike", &PlaneShape::strike, required, "deg", Range::closed(-360, 360),
          "The plane strikes along this azimuth, clockwise from y, and dips to the right of it.")
    .real("Dip", &PlaneShape::dip, required, "deg", Range::closed(0, 90),
          "The plane has this angle to the horizontal.")
    .real("Length", &PlaneShape::length, required, "m", Range::positive(),
          "The plane has this length along strike.")
    .real("Width", &PlaneShape::width, required, "m", Range::positive(),
          "The plane has this width down dip.");
  entries.others().choice("Units", "m", {"m", "km", "degrees"},
                          "Says in which unit 'Top Centre' is given; degrees are longitude and "
                          "latitude, which the projection takes to metres.");
  declareExtendUp(entries.others(), false);
  return entries;
}

TriangleSurface makePlane(ParameterList const& list, std::string const& path,
                          SurfaceContext const& context)
{
  auto shape = planeEntries().read(list, path);
  auto const& numbers = list.get<Teuchos::Array<double>>(top_centre);
  ASPERITY_REQUIRE(numbers.size() == 2 || numbers.size() == 3,
                   joinPath(path, top_centre)
                     << " has " << numbers.size() << " numbers; it needs x, y and perhaps z.");
  auto const& unit = list.get<std::string>("Units");
  Polyline centre = {{numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 0}};
  Units(unit, lengthUnit(unit), path, context).toModel(centre);
  shape.top_centre = centre.front();
  if (list.get<bool>("Extend Up")) {
    constexpr double radians = 0.017453292519943295;
    const double lower_z = shape.top_centre[2] - shape.width * std::sin(shape.dip * radians);
    shape = extendedUp(shape, aboveGround(lower_z, context), path);
  }
  return planeSurface(shape);
}

class PlaneKind final : public SurfaceKind
{
public:
  std::vector<std::string> sources() const override { return {top_centre}; }
  std::string fileEntry() const override { return ""; }
  FileFit fit(std::string const& /*file_name*/) const override { return FileFit::none; }
  Teuchos::RCP<const ParameterList> entries() const override { return planeEntries().list(); }
  TriangleSurface make(ParameterList const& list, std::string const& path,
                       SurfaceContext const& context) const override
  {
    return makePlane(list, path, context);
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceKindRegistry, "Plane", PlaneKind)
} // namespace asperity::geometry
