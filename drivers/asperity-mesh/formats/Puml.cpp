#include "MeshFormat.hpp"

#include "../GmshSession.hpp"

#include "base/Errors.hpp"
#include "hdf5/File.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace h5 = asperity::h5;
using asperity::GlobalMesh;

namespace
{
// What SeisSol means by the code of a face; codes above 64 are further faults.
std::string usualName(std::int64_t code)
{
  static const std::map<std::int64_t, std::string> names = {
    {1, "free_surface"}, {2, "free_surface_with_gravity"},
    {3, "fault"},        {4, "dirichlet"},
    {5, "absorbing"},    {6, "periodic"},
    {7, "analytical"}};
  const auto found = names.find(code);
  return found != names.end() ? found->second
                              : (code > 64 ? "fault_" : "boundary_") + std::to_string(code);
}

// Names by numbers, given or made, and those that are given for nothing.
class Names
{
public:
  using Maker = std::function<std::string(std::int64_t)>;
  Names(std::map<int, std::string> const& given, std::string option, std::string what, Maker make)
      : given_(given)
      , option_(std::move(option))
      , what_(std::move(what))
      , make_(std::move(make))
  {
  }

  std::string of(std::int64_t number)
  {
    const auto known = names_.find(number);
    if (known != names_.end()) {
      return known->second;
    }
    const auto given = std::find_if(given_.begin(), given_.end(),
                                    [&](auto const& item) { return item.first == number; });
    if (given != given_.end()) {
      return names_[number] = given->second;
    }
    auto const name = make_(number);
    remarks_ += what_ + ' ' + std::to_string(number) + " is called '" + name + "'; " + option_ +
                ' ' + std::to_string(number) + "=NAME gives another name\n";
    return names_[number] = name;
  }

  // What was made here, and what is given for nothing.
  void tell(std::string const& where) const
  {
    std::cout << remarks_;
    for (auto const& [number, name] : given_) {
      if (names_.count(number) == 0) {
        std::string present;
        for (auto const& item : names_) {
          present += (present.empty() ? "" : ", ") + std::to_string(item.first);
        }
        warn("Option " + option_ + ' ' + std::to_string(number) + '=' + name +
             " names nothing: " + where + " has no " + what_ + ' ' + std::to_string(number) +
             ", only " + (present.empty() ? "none" : present) + '.');
      }
    }
  }

private:
  std::map<int, std::string> const& given_;
  std::string option_, what_;
  Maker make_;
  std::map<std::int64_t, std::string> names_;
  std::string remarks_;
};

// The mesh of SeisSol, made by PUMGen: datasets connect (cells, 4), geometry (vertices, 3), group
// (cells) and boundary, which has a code for each face of a cell, 0 inside the body. The faces are
// the vertices (0, 2, 1), (0, 1, 3), (1, 2, 3) and (0, 3, 2). Faces inside the body have a code on
// both sides.
class PumlFile
{
public:
  PumlFile(std::string const& file_name, ReadOptions const& options)
      : where_("Mesh file '" + file_name + "'")
      , options_(options)
      , file_(h5::File::open(file_name))
      , region_names_(options.names.regions, "--region-names", "group",
                      [](std::int64_t number) { return "region_" + std::to_string(number); })
      , boundary_names_(options.names.boundaries, "--names", "face code", usualName)
  {
  }

  GlobalMesh<3> mesh()
  {
    readCells();
    readVertices();
    readRegions();
    readBoundaries();
    asperity::mesh::orientCells(mesh_);
    asperity::mesh::orientFacets(mesh_);
    asperity::mesh::checkMesh(mesh_, where_);
    region_names_.tell(where_);
    boundary_names_.tell(where_);
    return std::move(mesh_);
  }

private:
  // A dataset with rows of `columns` numbers, 0 for single ones.
  template <class Number>
  std::vector<Number> numbers(std::string const& name, hsize_t columns, std::size_t rows) const
  {
    ASPERITY_REQUIRE(file_.has(name), where_ << " has no dataset '" << name
                                             << "', as a mesh of SeisSol in PUML has.");
    auto const dataset = file_.openDataset(name);
    auto const shape = dataset.shape();
    const bool has_shape =
      shape.size() == (columns == 0 ? 1U : 2U) && (columns == 0 || shape[1] == columns);
    const bool is_number =
      dataset.valueClass() == h5::ValueClass::integer ||
      (std::is_floating_point_v<Number> && dataset.valueClass() == h5::ValueClass::real);
    ASPERITY_REQUIRE(
      has_shape && is_number && (rows == any_number || shape[0] == rows),
      where_ << ": dataset '" << name << "' needs "
             << (rows == any_number ? std::string("any number of") : std::to_string(rows))
             << " rows of "
             << (columns == 0 ? std::string("a number") : std::to_string(columns) + " numbers")
             << (std::is_floating_point_v<Number> ? "." : ", which are integers."));
    dataset.requireStorage();
    return dataset.read<Number>();
  }

  void readCells()
  {
    auto const connect = numbers<std::int64_t>("connect", 4, any_number);
    ASPERITY_REQUIRE(!connect.empty(), where_ << " has no cells.");
    std::set<std::int64_t> used;
    for (auto vertex : connect) {
      used.insert(vertex);
    }
    used_.assign(used.begin(), used.end());
    for (std::size_t i = 0; i < connect.size(); i += 4) {
      auto& cell = mesh_.cells.emplace_back();
      std::transform(&connect[i], &connect[i] + 4, cell.begin(), [&](std::int64_t vertex) {
        return static_cast<int>(std::lower_bound(used_.begin(), used_.end(), vertex) -
                                used_.begin());
      });
    }
  }

  // Of the vertices that cells have.
  void readVertices()
  {
    auto const geometry = numbers<double>("geometry", 3, any_number);
    const auto count = static_cast<std::int64_t>(geometry.size() / 3);
    for (auto vertex : used_) {
      ASPERITY_REQUIRE(vertex >= 0 && vertex < count, where_ << ": a cell has vertex " << vertex
                                                             << ", outside [0, " << count << ").");
      auto& point = mesh_.vertices.emplace_back();
      for (int d = 0; d < 3; ++d) {
        point[d] = options_.scale * geometry[static_cast<std::size_t>(3 * vertex + d)];
      }
    }
  }

  void readRegions()
  {
    auto const groups = numbers<std::int64_t>("group", 0, mesh_.cells.size());
    const std::set<std::int64_t> different(groups.begin(), groups.end());
    std::map<std::int64_t, int> region_of_group;
    for (auto group : different) {
      auto const name = region_names_.of(group);
      auto& names = mesh_.region_names;
      const auto found = std::find(names.begin(), names.end(), name);
      region_of_group[group] = static_cast<int>(found - names.begin());
      if (found == names.end()) {
        names.push_back(name);
      }
    }
    for (auto group : groups) {
      mesh_.cell_regions.push_back(region_of_group[group]);
    }
  }

  // The codes of the four faces of each cell.
  std::vector<std::array<std::int64_t, 4>> codes() const
  {
    const auto num_cells = mesh_.cells.size();
    std::vector<std::array<std::int64_t, 4>> result(num_cells);
    const std::string name = "boundary";
    if (file_.has(name) && file_.openDataset(name).shape().size() == 2) {
      auto const single = numbers<std::int64_t>(name, 4, num_cells);
      for (std::size_t i = 0; i < single.size(); ++i) {
        result[i / 4][i % 4] = single[i];
      }
      return result;
    }
    auto const packed = numbers<std::int64_t>(name, 0, num_cells);
    const int bits = bitsOfCode(packed);
    for (std::size_t cell = 0; cell < num_cells; ++cell) {
      const auto word = static_cast<std::uint64_t>(packed[cell]);
      for (int face = 0; face < 4; ++face) {
        result[cell][face] =
          static_cast<std::int64_t>((word >> (bits * face)) & ((std::uint64_t(1) << bits) - 1));
      }
    }
    return result;
  }

  // Of a face, 8 or 16. What the file says may be missing or no text that HDF5 gives us; four codes
  // of 16 bits do not fit into 32.
  int bitsOfCode(std::vector<std::int64_t> const& packed) const
  {
    const std::string attribute = "boundary-format";
    auto const dataset = file_.openDataset("boundary");
    for (auto const* object : std::array<h5::Object const*, 2>{&file_, &dataset}) {
      if (object->hasAttribute(attribute)) {
        try {
          auto const format = object->textAttribute(attribute);
          ASPERITY_REQUIRE(format == "i32" || format == "i64",
                           where_ << ": boundary has one number for each cell, which '" << attribute
                                  << "' = " << format << " does not describe: i32 or i64.");
          return format == "i64" ? 16 : 8;
        } catch (h5::Error const&) { // decided by the values
        }
      }
    }
    const bool fits = std::all_of(packed.begin(), packed.end(), [](std::int64_t word) {
      return word >= std::numeric_limits<std::int32_t>::min() &&
             word <= std::numeric_limits<std::uint32_t>::max();
    });
    return fits ? 8 : 16;
  }

  void readBoundaries()
  {
    static constexpr int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    auto const code = codes();
    std::map<std::int64_t, std::set<std::array<int, 3>>> known; // by ascending vertices
    for (std::size_t cell = 0; cell < code.size(); ++cell) {
      for (int face = 0; face < 4; ++face) {
        if (code[cell][face] == 0) {
          continue;
        }
        std::array<int, 3> facet;
        std::transform(faces[face], faces[face] + 3, facet.begin(),
                       [&](int vertex) { return mesh_.cells[cell][vertex]; });
        auto sorted = facet;
        std::sort(sorted.begin(), sorted.end());
        if (known[code[cell][face]].insert(sorted).second) { // a fault has it on both sides
          facets_[code[cell][face]].push_back(facet);
        }
      }
    }
    for (auto const& [number, facets] : facets_) {
      auto& boundary = mesh_.boundaries[boundary_names_.of(number)];
      boundary.insert(boundary.end(), facets.begin(), facets.end());
    }
    leaveOut();
  }

  void leaveOut()
  {
    std::vector<std::string> boundaries;
    for (auto const& item : mesh_.boundaries) {
      boundaries.push_back(item.first);
    }
    requireBoundaries(options_.names.without, boundaries, mesh_.region_names, where_);
    for (auto const& name : options_.names.without) {
      mesh_.boundaries.erase(name);
    }
  }

  static constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

  std::string where_;
  ReadOptions const& options_;
  h5::File file_;
  Names region_names_, boundary_names_;
  GlobalMesh<3> mesh_;
  std::vector<std::int64_t> used_; // vertices of the file, ascending
  std::map<std::int64_t, std::vector<std::array<int, 3>>> facets_;
};

class Puml final : public MeshFormat
{
public:
  std::vector<std::string> endings() const override { return {".puml.h5"}; }
  AnyMesh read(std::string const& file_name, ReadOptions const& options) const override
  {
    try {
      return PumlFile(file_name, options).mesh();
    } catch (h5::Error const& error) { // an error of this file's, not of one that is written
      throw asperity::InputError("Mesh file '" + file_name + "' cannot be read. " + error.what());
    }
  }
};
} // namespace

ASPERITY_REGISTER(MeshFormatRegistry, "PUML", Puml)
