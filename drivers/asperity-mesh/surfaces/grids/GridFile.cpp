#include "surfaces/grids/GridFile.hpp"

#include "surfaces/FileNames.hpp"
#include "surfaces/grids/GridFormats.hpp"

#include "base/Errors.hpp"

namespace asperity::geometry
{
namespace
{
const std::vector<FileFormat<GridReader>> grid_formats = {
  {".nc", readNetcdfGrid}, {".grd", readNetcdfGrid}, {".cdf", readNetcdfGrid},
  {".asc", readEsriGrid},  {".xyz", readPointGrid},  {".hgt", readSrtmGrid}};
} // namespace

GridData readGrid(std::string const& file_name, std::string const& variable)
{
  auto const reader = formatOf(grid_formats, file_name, "Grid file");
  ASPERITY_REQUIRE(variable.empty() || reader == readNetcdfGrid,
                   "Grid file '" << file_name << "' has no variables, but variable '" << variable
                                 << "' is wanted.");
  return reader(file_name, variable);
}

bool isGridFile(std::string const& file_name)
{
  return findFormat(grid_formats, file_name) != nullptr;
}
} // namespace asperity::geometry
