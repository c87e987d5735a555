#include "surfaces/FileNames.hpp"
#include "surfaces/Weld.hpp"
#include "surfaces/grids/GridFile.hpp"
#include "surfaces/grids/GridFormat.hpp"
#include "surfaces/grids/SampledGrid.hpp"
#include "surfaces/kinds/SurfaceKind.hpp"
#include "surfaces/kinds/Units.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
namespace
{
constexpr char const* grid_file = "Grid File";
constexpr char const* from_file = "from file";

Teuchos::RCP<const ParameterList> gridEntries()
{
  return Declare()
    .fileName(grid_file, required,
              "The grid is in this file: " + describeFormats<GridFormat>() + ".")
    .text("Variable", "",
          "Selects a variable of a netCDF file; a file with one grid needs no name.")
    .choice("Units", from_file, {from_file, "m", "km", "degrees"},
            "Says in which unit x and y of the grid are given, where the file does not tell it; "
            "degrees are longitude and latitude, which the projection takes to metres.")
    .choice("Depth Units", from_file, {from_file, "m", "km"},
            "Says in which unit the values of the grid are given, where the file does not tell it.")
    .choice("Values", from_file, {from_file, "Elevation", "Depth"},
            "Says whether values are positive upward (Elevation) or downward (Depth); a file that "
            "does not tell it has elevations.")
    .real("Step", 0., "m", Range::atLeast(0),
          "Points of the ground have this spacing; points of a fault have at least this spacing. "
          "0 makes it that of the grid.")
    .choice("Outside", "Refuse", {"Refuse", "Clamp"},
            "Says what the ground is outside of the grid: an error, or as high as at the nearest "
            "edge.")
    .list();
}

// The value of an entry that the file may also state. InputError if file and deck disagree, since
// either may be wrong.
template <class Value>
Value agreed(ParameterList const& list, std::string const& path, char const* name,
             std::string const& where, bool is_in_file, Value const& in_file, Value const& given)
{
  const bool is_given = list.get<std::string>(name) != from_file;
  ASPERITY_REQUIRE(is_given || is_in_file, joinPath(path, name)
                                             << " is missing: " << where << " does not tell it.");
  ASPERITY_REQUIRE(!is_given || !is_in_file || given == in_file,
                   joinPath(path, name)
                     << " = '" << list.get<std::string>(name) << "' contradicts " << where
                     << ", which tells it. Remove the entry, or correct the "
                        "file.");
  return is_given ? given : in_file;
}

TriangleSurface makeGrid(ParameterList const& list, std::string const& path,
                         SurfaceContext const& context)
{
  auto data = readGrid(fileOf(list, grid_file, context), list.get<std::string>("Variable"));
  auto const& where = data.grid.where();
  const auto unit = agreed(list, path, "Units", where, !data.horizontal_unit.empty(),
                           data.horizontal_unit, list.get<std::string>("Units"));
  const double vertical =
    agreed(list, path, "Depth Units", where, data.vertical_unit > 0, data.vertical_unit,
           lengthUnit(list.get<std::string>("Depth Units")));
  auto const& values = list.get<std::string>("Values");
  const bool is_depth = values == from_file ? data.is_depth : values == "Depth";
  data.grid.scale(is_depth ? -vertical : vertical);
  if (unit == "degrees") {
    data.grid.setPeriodic();
  }
  const Units units(unit, 1, path, context);
  const double step = list.get<double>("Step");
  if (!context.area) {
    return welded(surfaceOf(data.grid, units, step), where, context.remark);
  }
  return groundOf(data.grid, units, *context.area, step,
                  list.get<std::string>("Outside") == "Clamp" ? Outside::clamp : Outside::refuse);
}

class GridKind final : public SurfaceKind
{
public:
  std::vector<std::string> sources() const override { return {grid_file}; }
  std::string fileEntry() const override { return grid_file; }
  FileFit fit(std::string const& file_name) const override
  {
    return findFormat<GridFormat>(uncompressedName(file_name)).format != nullptr ? FileFit::certain
                                                                                 : FileFit::none;
  }
  Teuchos::RCP<const ParameterList> entries() const override { return gridEntries(); }
  TriangleSurface make(ParameterList const& list, std::string const& path,
                       SurfaceContext const& context) const override
  {
    return makeGrid(list, path, context);
  }
};
} // namespace

ASPERITY_REGISTER(SurfaceKindRegistry, "Grid", GridKind)
} // namespace asperity::geometry
