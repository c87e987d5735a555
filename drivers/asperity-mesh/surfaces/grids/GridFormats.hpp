#pragma once

#include "surfaces/grids/GridFile.hpp"

#include <string>

namespace asperity::geometry
{
// A format of grids. To add one: a file with its reader, a declaration here and a line in the table
// of GridFile.cpp.
using GridReader = GridData (*)(std::string const& file_name, std::string const& variable);

GridData readNetcdfGrid(std::string const& file_name, std::string const& variable);
GridData readEsriGrid(std::string const& file_name, std::string const& variable);
GridData readPointGrid(std::string const& file_name, std::string const& variable);
GridData readSrtmGrid(std::string const& file_name, std::string const& variable);
} // namespace asperity::geometry
