#pragma once

#include "surfaces/grids/Grid.hpp"

#include <string>

namespace asperity::geometry
{
// A grid of a file in the file's units, and what the file says of them.
struct GridData
{
  Grid grid;
  std::string horizontal_unit; // "m", "km", "degrees"; "" if the file does not say it
  double vertical_unit = 0;    // [m]; 0 if the file does not say it
  bool is_depth = false;       // z is positive downward, by the file
};

// Reads a grid by the extension of the file, in one of the registered formats (GridFormat).
// variable: of a netCDF file, "" if it has one of two dimensions. InputError with file, place and
// what is expected for what is damaged or no grid.
GridData readGrid(std::string const& file_name, std::string const& variable = "");
} // namespace asperity::geometry
