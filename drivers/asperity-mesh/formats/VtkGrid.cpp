#include "formats/VtkGrid.hpp"

#include "Warnings.hpp"
#include "assembly/CellShape.hpp"
#include "assembly/ForeignMesh.hpp"
#include "assembly/GroupNaming.hpp"

#include "base/Errors.hpp"
#include "base/NearestName.hpp"
#include "base/Text.hpp"
#include "mesh/GlobalMesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::geometry
{
namespace
{
constexpr char const* array_option = "--array";

// Of dimension, with as many corners; 0 corners: it is skipped.
struct CellType
{
  int dimension, num_corners;
};

CellType cellType(std::int64_t type)
{
  static const std::map<std::int64_t, CellType> types = {
    {1, {0, 0}},  {2, {0, 0}},  {3, {1, 2}},  {5, {2, 3}},  {8, {2, 4}},  {9, {2, 4}},
    {10, {3, 4}}, {11, {3, 8}}, {12, {3, 8}}, {13, {3, 6}}, {14, {3, 5}}, {21, {1, 2}},
    {22, {2, 3}}, {23, {2, 4}}, {24, {3, 4}}, {25, {3, 8}}, {26, {3, 6}}, {27, {3, 5}},
    {28, {2, 4}}, {29, {3, 8}}, {32, {3, 6}}, {34, {2, 3}}};
  const auto found = types.find(type);
  return found == types.end() ? CellType{-1, 0} : found->second;
}

class Conversion
{
public:
  Conversion(VtkGrid const& grid, ReadOptions const& options, std::string const& where)
      : grid_(grid)
      , options_(options)
      , where_(where)
      , region_names_(options.names.regions, regions_option, "number", makerOf("region_"))
      , boundary_names_(options.names.boundaries, boundaries_option, "number", makerOf("boundary_"))
  {
  }

  AnyMesh run()
  {
    requireCounts(grid_, where_);
    for (std::size_t i = 0; i + 2 < grid_.points.size(); i += 3) {
      mesh_.vertices.push_back({grid_.points[i], grid_.points[i + 1], grid_.points[i + 2]});
    }
    const bool is_solid = std::any_of(grid_.types.begin(), grid_.types.end(),
                                      [](auto type) { return cellType(type).dimension == 3; });
    mesh_.dimension = is_solid ? 3 : 2;
    numbers_ = numbers();
    for (std::size_t cell = 0; cell < grid_.types.size(); ++cell) {
      add(cell);
    }
    ASPERITY_REQUIRE(!mesh_.cells.empty(), where_ << " has no cells.");
    return mesh_.dimension == 2 ? AnyMesh(finished<2>()) : AnyMesh(finished<3>());
  }

private:
  static GroupNaming::Maker makerOf(std::string const& begin)
  {
    return [begin](std::int64_t number) { return begin + std::to_string(number); };
  }

  template <int Dim>
  GlobalMesh<Dim> finished()
  {
    auto result = assemble<Dim>(mesh_, options_.assembly, where_);
    region_names_.finish(where_);
    boundary_names_.finish(where_);
    if (result.boundaries.empty()) {
      warn(where_ + " has no " + (Dim == 3 ? "triangles or quadrilaterals" : "lines") +
           " beside its cells, and therefore no boundaries and faults.");
    }
    return result;
  }

  static bool isWhole(std::vector<double> const& values)
  {
    return std::all_of(values.begin(), values.end(), [](double value) {
      return value == std::floor(value) && std::abs(value) < 1e9;
    });
  }

  // Of the group of each cell; empty if there are none.
  std::vector<double> numbers() const
  {
    static constexpr std::array<char const*, 8> usual = {
      "gmsh:physical", "CellEntityIds", "medit:ref", "cell_tags",
      "MaterialIds",   "MaterialID",    "material",  "region"};
    std::vector<std::string> known;
    for (auto const& [name, values] : grid_.cell_data) {
      if (values.size() == grid_.types.size() && isWhole(values)) {
        known.push_back(name);
      }
    }
    const auto array = options_.valueOf(array_option);
    const auto has = [&](std::string const& name) {
      return std::find(known.begin(), known.end(), name) != known.end();
    };
    if (!array.empty()) {
      ASPERITY_REQUIRE(has(array), "Option "
                                     << array_option << " " << array << ": " << where_
                                     << " has no such array of cell data with whole numbers, only "
                                     << quotedNames(known) << '.' << didYouMean(array, known));
      return grid_.cell_data.at(array);
    }
    for (auto const* name : usual) {
      if (has(name)) {
        return grid_.cell_data.at(name);
      }
    }
    ASPERITY_REQUIRE(known.size() <= 1, where_
                                          << " has several arrays of cell data with whole numbers, "
                                          << quotedNames(known)
                                          << ". Give --array NAME for those of the groups.");
    return known.empty() ? std::vector<double>() : grid_.cell_data.at(known.front());
  }

  void add(std::size_t cell)
  {
    const auto type = cellType(grid_.types[cell]);
    ASPERITY_REQUIRE(type.dimension >= 0, where_ << ": cell " << cell << " is of VTK's type "
                                                 << grid_.types[cell]
                                                 << ". Only cells of first and, with --simplices, "
                                                    "second order can be read.");
    if (type.dimension < mesh_.dimension - 1 || type.num_corners == 0) {
      return;
    }
    auto nodes = nodesOf(cell, type);
    const auto number = numbers_.empty() ? 1 : static_cast<std::int64_t>(numbers_[cell]);
    if (type.dimension == mesh_.dimension) {
      mesh_.addCell(mesh_.region(region_names_.nameOf(number)), nodes, type.num_corners,
                    static_cast<std::int64_t>(cell));
    } else {
      nodes.resize(static_cast<std::size_t>(type.num_corners));
      mesh_.group(boundary_names_.nameOf(number)).sides.push_back(ForeignMesh::side(nodes));
    }
  }

  std::vector<int> nodesOf(std::size_t cell, CellType const& type) const
  {
    const auto begin = cell == 0 ? 0 : grid_.offsets[cell - 1];
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    std::vector<int> nodes;
    for (auto i = begin; i < grid_.offsets[cell]; ++i) {
      const auto node = grid_.connectivity[static_cast<std::size_t>(i)];
      ASPERITY_REQUIRE(node >= 0 && node < count, where_ << ": cell " << cell << " has point "
                                                         << node << ", outside [0, " << count
                                                         << ").");
      nodes.push_back(static_cast<int>(node));
    }
    const auto num_nodes = static_cast<int>(nodes.size());
    const int corners = type.dimension == 1 ? (num_nodes == 2 || num_nodes == 3 ? 2 : 0)
                                            : cornersOfCell(type.dimension, num_nodes);
    ASPERITY_REQUIRE(corners == type.num_corners, where_ << ": cell " << cell << " of VTK's type "
                                                         << grid_.types[cell] << " has "
                                                         << num_nodes << " points.");
    if (grid_.types[cell] == 8 || grid_.types[cell] == 11) { // pixel, voxel: row by row
      std::swap(nodes[2], nodes[3]);
      if (num_nodes == 8) {
        std::swap(nodes[6], nodes[7]);
      }
    }
    return nodes;
  }

  VtkGrid const& grid_;
  ReadOptions const& options_;
  std::string const& where_;
  GroupNaming region_names_, boundary_names_;
  ForeignMesh mesh_{3};
  std::vector<double> numbers_;
};
} // namespace

void requireCounts(VtkGrid const& grid, std::string const& where)
{
  ASPERITY_REQUIRE(grid.offsets.size() == grid.types.size(), where << " has " << grid.offsets.size()
                                                                   << " cells, but types of "
                                                                   << grid.types.size() << '.');
  std::int64_t last = 0;
  for (auto offset : grid.offsets) {
    ASPERITY_REQUIRE(offset >= last &&
                       offset <= static_cast<std::int64_t>(grid.connectivity.size()),
                     where << ": the offset " << offset << " of a cell is outside [" << last << ", "
                           << grid.connectivity.size() << "].");
    last = offset;
  }
}

std::vector<FormatOption> vtkOptions()
{
  return {{array_option, "NAME", "cell data with the numbers of regions and boundaries"}};
}

AnyMesh meshOf(VtkGrid const& grid, ReadOptions const& options, std::string const& where)
{
  return Conversion(grid, options, where).run();
}
} // namespace asperity::geometry
