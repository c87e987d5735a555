#pragma once

#include "formats/MeshFormat.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace asperity::geometry
{
// An unstructured grid of VTK, from a legacy file or from XML.
struct VtkGrid
{
  std::vector<double> points; // (num_points, 3)
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets; // (num_cells), of the first node behind each cell
  std::vector<std::int64_t> types;   // (num_cells), VTK's numbers
  std::map<std::string, std::vector<double>> cell_data; // with one number for each cell
};

// InputError, which starts with `where`, unless there are offsets and types of as many cells, and
// the offsets fit the connectivity.
void requireCounts(VtkGrid const& grid, std::string const& where);

// --array: the cell data that number the groups.
std::vector<FormatOption> vtkOptions();

// Cells of the highest dimension become cells, those of one less sides; the numbers of their groups
// are the array of cell data that the options name, or one of the names that other programs use, or
// the only one with whole numbers. InputError, which starts with `where`, for counts that do not
// fit, cells of other types, and if no array can be chosen.
AnyMesh meshOf(VtkGrid const& grid, ReadOptions const& options, std::string const& where);
} // namespace asperity::geometry
