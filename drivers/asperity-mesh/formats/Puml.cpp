#include "assembly/CellShape.hpp"
#include "assembly/ForeignMesh.hpp"
#include "assembly/GroupNaming.hpp"
#include "formats/MeshFormat.hpp"

#include "base/Errors.hpp"
#include "hdf5/File.hpp"
#include "mesh/GlobalMesh.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace asperity::geometry
{
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
      , region_names_(options.names.regions, regions_option, "group",
                      [](std::int64_t number) { return "region_" + std::to_string(number); })
      , boundary_names_(options.names.boundaries, boundaries_option, "face code", usualName)
  {
  }

  GlobalMesh<3> mesh()
  {
    readCells();
    readVertices();
    readBoundaries();
    auto result = assemble<3>(mesh_, options_.assembly, where_);
    region_names_.finish(where_);
    boundary_names_.finish(where_);
    return result;
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
    const auto num_cells = connect.size() / 4;
    const auto count =
      static_cast<std::int64_t>(numbers<double>("geometry", 3, any_number).size() / 3);
    auto const groups = numbers<std::int64_t>("group", 0, num_cells);
    for (auto group : std::set<std::int64_t>(groups.begin(), groups.end())) {
      mesh_.region(region_names_.nameOf(group));
    }
    for (std::size_t cell = 0; cell < num_cells; ++cell) {
      std::vector<int> corners;
      for (std::size_t i = 4 * cell; i < 4 * cell + 4; ++i) {
        ASPERITY_REQUIRE(connect[i] >= 0 && connect[i] < count,
                         where_ << ": a cell has vertex " << connect[i] << ", outside [0, " << count
                                << ").");
        corners.push_back(static_cast<int>(connect[i]));
      }
      mesh_.addCell(mesh_.region(region_names_.nameOf(groups[cell])), corners, 4,
                    static_cast<std::int64_t>(cell));
    }
  }

  void readVertices()
  {
    auto const geometry = numbers<double>("geometry", 3, any_number);
    for (std::size_t i = 0; i < geometry.size(); i += 3) {
      mesh_.vertices.push_back({geometry[i], geometry[i + 1], geometry[i + 2]});
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
    auto const code = codes();
    std::map<std::int64_t, std::string> names; // ascending codes
    for (auto const& of_cell : code) {
      for (auto number : of_cell) {
        names.emplace(number, "");
      }
    }
    names.erase(0);
    for (auto& [number, name] : names) {
      name = boundary_names_.nameOf(number);
    }
    for (std::size_t cell = 0; cell < code.size(); ++cell) {
      for (std::size_t face = 0; face < 4; ++face) {
        if (code[cell][face] != 0) { // the order of the sides is that of SeisSol
          mesh_.addSide(names.at(code[cell][face]), static_cast<int>(cell), sidesOf(3, 4)[face]);
        }
      }
    }
  }

  static constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

  std::string where_;
  ReadOptions const& options_;
  h5::File file_;
  GroupNaming region_names_, boundary_names_;
  ForeignMesh mesh_{3};
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
      throw InputError("Mesh file '" + file_name + "' cannot be read. " + error.what());
    }
  }
};
} // namespace

ASPERITY_REGISTER(MeshFormatRegistry, "PUML of SeisSol", Puml)
} // namespace asperity::geometry
