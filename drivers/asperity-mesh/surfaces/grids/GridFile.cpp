#include "surfaces/grids/GridFile.hpp"

#include "surfaces/FileNames.hpp"
#include "surfaces/grids/GridFormat.hpp"

#include "base/Errors.hpp"

namespace asperity::geometry
{
GridData readGrid(std::string const& file_name, std::string const& variable)
{
  auto const& format = formatOf<GridFormat>(file_name, "Grid file");
  ASPERITY_REQUIRE(variable.empty() || format.hasVariables(),
                   "Grid file '" << file_name << "' has no variables, but variable '" << variable
                                 << "' is wanted.");
  return format.read(file_name, variable);
}
} // namespace asperity::geometry
