#include "assembly/CellShape.hpp"
#include "assembly/ForeignMesh.hpp"
#include "assembly/GroupNaming.hpp"
#include "assembly/NodeSets.hpp"
#include "formats/MeshFormat.hpp"
#include "surfaces/netcdf/NetcdfFile.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/GlobalMesh.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace asperity::geometry
{
// Exodus II, in classic netCDF or netCDF-4. Blocks of elements are connect1, connect2 ..., side
// sets elem_ss1 and side_ss1 ..., node sets node_ns1 ...; their numbers are in eb_prop1, ss_prop1
// and ns_prop1, their names in eb_names, ss_names and ns_names. All numbers begin with 1.
namespace
{
// The shape that begins with this type's name.
struct ElementType
{
  char const* begin;
  int dimension, num_corners; // 0: as many as nodes
};
constexpr ElementType element_types[] = {
  {"TRI", 2, 3}, {"QUA", 2, 4}, {"SHELL", 2, 0},  {"TET", 3, 4},  {"PYR", 3, 5},   {"WED", 3, 6},
  {"PEN", 3, 6}, {"HEX", 3, 8}, {"BAR", 1, 2},    {"BEAM", 1, 2}, {"TRUSS", 1, 2}, {"EDGE", 1, 2},
  {"ROD", 1, 2}, {"SPH", 0, 1}, {"CIRCLE", 0, 1}, {"NODE", 0, 1}};

// Side K + 1 of an element, as places among its corners.
std::vector<std::vector<int>> const& exodusSides(int dimension, int num_corners)
{
  static const std::map<int, std::vector<std::vector<int>>> in_space = {
    {4, {{0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 2, 1}}},
    {5, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}, {0, 3, 2, 1}}},
    {6, {{0, 1, 4, 3}, {1, 2, 5, 4}, {0, 3, 5, 2}, {0, 2, 1}, {3, 4, 5}}},
    {8, {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}}};
  return dimension == 3 ? in_space.at(num_corners) : sidesOf(dimension, num_corners);
}

class ExodusFile
{
public:
  ExodusFile(std::string const& file_name, ReadOptions const& options)
      : where_("Mesh file '" + file_name + "'")
      , options_(options)
      , file_(openNetcdf(file_name, "Mesh file"))
      , region_names_(options.names.regions, regions_option, "block", makerOf("region_"))
      , boundary_names_(options.names.boundaries, boundaries_option, "set", makerOf("boundary_"))
  {
  }

  AnyMesh mesh()
  {
    readVertices();
    readBlocks();
    readSideSets();
    readNodeSets();
    return mesh_.dimension == 2 ? AnyMesh(finished<2>()) : AnyMesh(finished<3>());
  }

private:
  struct Block
  {
    std::string variable, name;
    std::int64_t id;
    ElementType type;
    int num_nodes, num_corners;
    std::size_t num_cells;
  };

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
    tellOfEmptySets(empty_);
    return result;
  }

  void readVertices()
  {
    const bool is_one = file_->has("coord");
    std::vector<std::vector<double>> coordinates(3);
    if (is_one) {
      const auto all = file_->numbers("coord");
      auto const& shape = file_->variable("coord").shape;
      ASPERITY_REQUIRE(shape.size() == 2 && shape[0] <= 3,
                       where_ << ": variable 'coord' needs up to three rows.");
      const auto count = static_cast<std::ptrdiff_t>(shape[1]);
      for (std::size_t d = 0; d < shape[0]; ++d) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(d) * count;
        coordinates[d].assign(begin, begin + count);
      }
    } else {
      for (int d = 0; d < 3; ++d) {
        const std::string name = std::string("coord") + "xyz"[d];
        if (d < 2 || file_->has(name)) {
          coordinates[static_cast<std::size_t>(d)] = file_->numbers(name);
        }
      }
    }
    coordinates[2].resize(std::max(coordinates[2].size(), coordinates[0].size()));
    ASPERITY_REQUIRE(coordinates[0].size() == coordinates[1].size() &&
                       coordinates[0].size() == coordinates[2].size(),
                     where_ << ": there are different numbers of x, y and z.");
    for (std::size_t v = 0; v < coordinates[0].size(); ++v) {
      mesh_.vertices.push_back({coordinates[0][v], coordinates[1][v], coordinates[2][v]});
      mesh_.numbers.push_back(static_cast<std::int64_t>(v) + 1);
    }
  }

  // Of `kind`, as "ss": their numbers, and names if the file has any.
  std::vector<std::pair<std::int64_t, std::string>> listed(std::string const& kind) const
  {
    std::vector<std::pair<std::int64_t, std::string>> result;
    const auto ids = kind + "_prop1", names = kind + "_names";
    if (file_->has(ids)) {
      for (double id : file_->numbers(ids)) {
        result.emplace_back(static_cast<std::int64_t>(id), "");
      }
    }
    if (file_->has(names)) {
      const auto texts = file_->texts(names);
      for (std::size_t i = 0; i < std::min(texts.size(), result.size()); ++i) {
        result[i].second = texts[i];
      }
    }
    return result;
  }

  // Positions of what has the numbers of a variable, from 1 on.
  std::vector<int> positions(std::string const& name, std::size_t count, char const* what) const
  {
    std::vector<int> result;
    for (double number : file_->numbers(name)) {
      ASPERITY_REQUIRE(number >= 1 && number <= static_cast<double>(count),
                       where_ << ": variable '" << name << "' has " << what << ' '
                              << formatNumber(number) << ", outside [1, " << count << "].");
      result.push_back(static_cast<int>(number) - 1);
    }
    return result;
  }

  Block block(std::string const& variable, std::int64_t id, std::string const& name) const
  {
    auto const& connect = file_->variable(variable);
    std::string type = connect.text("elem_type");
    std::transform(type.begin(), type.end(), type.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const auto known =
      std::find_if(std::begin(element_types), std::end(element_types),
                   [&](ElementType const& one) { return type.rfind(one.begin, 0) == 0; });
    ASPERITY_REQUIRE(known != std::end(element_types) && connect.shape.size() == 2,
                     where_ << ": block " << id << " has elements of type '" << type
                            << "'. Triangles, quadrilaterals, tetrahedra, pyramids, wedges and "
                               "hexahedra can be read.");
    const auto num_nodes = static_cast<int>(std::min<std::uint64_t>(connect.shape[1], 1000));
    const int num_corners =
      known->dimension < 2 ? num_nodes : cornersOfCell(known->dimension, num_nodes);
    ASPERITY_REQUIRE(
      known->dimension < 2 ||
        (num_corners > 0 && (known->num_corners == 0 || num_corners == known->num_corners)),
      where_ << ": block " << id << " has elements of type '" << type << "' with " << num_nodes
             << " nodes. Only cells of first and, with --simplices, "
             << "second order can be read.");
    return {variable, name, id, *known, num_nodes, num_corners, connect.shape[0]};
  }

  // Those of the highest dimension are cells; of one less, sides of cells.
  void readBlocks()
  {
    std::vector<Block> blocks;
    const auto ids = listed("eb");
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto name = "connect" + std::to_string(i + 1);
      if (file_->has(name)) { // a block may be empty
        blocks.push_back(block(name, ids[i].first, ids[i].second));
      }
    }
    const bool is_solid = std::any_of(blocks.begin(), blocks.end(),
                                      [](auto const& one) { return one.type.dimension == 3; });
    mesh_.dimension = is_solid ? 3 : 2;
    for (auto const& one : blocks) {
      const auto nodes = positions(one.variable, mesh_.vertices.size(), "node");
      const auto step = static_cast<std::size_t>(one.num_nodes);
      std::vector<std::vector<int>> elements;
      for (std::size_t at = 0; step > 0 && at < nodes.size(); at += step) {
        elements.emplace_back(&nodes[at], &nodes[at] + step);
      }
      if (one.type.dimension == mesh_.dimension) {
        addCells(one, elements);
      } else {
        addSides(one, elements);
      }
    }
    ASPERITY_REQUIRE(!mesh_.cells.empty(), where_ << " has no cells.");
  }

  void addCells(Block const& block, std::vector<std::vector<int>> const& elements)
  {
    const int region = mesh_.region(region_names_.nameOf(block.id, block.name));
    for (auto const& nodes : elements) {
      cell_of_element_.push_back(static_cast<int>(mesh_.cells.size()));
      mesh_.addCell(region, nodes, block.num_corners,
                    static_cast<std::int64_t>(cell_of_element_.size()));
    }
  }

  void addSides(Block const& block, std::vector<std::vector<int>> const& elements)
  {
    cell_of_element_.resize(cell_of_element_.size() + elements.size(), -1);
    if (block.type.dimension == mesh_.dimension - 1 && !elements.empty()) {
      auto& sides = mesh_.group(boundary_names_.nameOf(block.id, block.name)).sides;
      const auto corners = mesh_.dimension == 2 ? 2 : block.num_corners;
      for (auto const& nodes : elements) {
        sides.push_back(ForeignMesh::side({nodes.begin(), nodes.begin() + corners}));
      }
    }
  }

  void readSideSets()
  {
    const auto ids = listed("ss");
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto number = std::to_string(i + 1);
      const std::string elements = "elem_ss" + number, sides = "side_ss" + number;
      if (!file_->has(elements)) {
        continue; // empty
      }
      const auto of_cell = positions(elements, cell_of_element_.size(), "element");
      const auto which = positions(sides, 6, "side");
      ASPERITY_REQUIRE(of_cell.size() == which.size(), where_ << ": variables '" << elements
                                                              << "' and '" << sides
                                                              << "' have different lengths.");
      const auto name = boundary_names_.nameOf(ids[i].first, ids[i].second);
      for (std::size_t k = 0; k < which.size(); ++k) {
        addSide(name, of_cell[k], which[k]);
      }
    }
  }

  void addSide(std::string const& name, int element, int side)
  {
    const int number = cell_of_element_[static_cast<std::size_t>(element)];
    ASPERITY_REQUIRE(number >= 0, where_ << ": side set '" << name << "' has a side of element "
                                         << element + 1 << ", which is no cell.");
    auto const& cell = mesh_.cells[static_cast<std::size_t>(number)];
    auto const& sides = exodusSides(mesh_.dimension, cell.num_corners);
    ASPERITY_REQUIRE(side < static_cast<int>(sides.size()),
                     where_ << ": side set '" << name << "' has side " << side + 1 << " of element "
                            << element + 1 << ", which has " << sides.size() << '.');
    mesh_.addSide(name, number, sides[static_cast<std::size_t>(side)]);
  }

  void readNodeSets()
  {
    const auto ids = listed("ns");
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto variable = "node_ns" + std::to_string(i + 1);
      if (file_->has(variable)) {
        const auto name = boundary_names_.nameOf(ids[i].first, ids[i].second);
        if (!addNodeSet(mesh_, name, positions(variable, mesh_.vertices.size(), "node"))) {
          empty_.push_back(name);
        }
      }
    }
  }

  std::string where_;
  ReadOptions const& options_;
  std::unique_ptr<NetcdfFile> file_;
  GroupNaming region_names_, boundary_names_;
  ForeignMesh mesh_{3};
  std::vector<int> cell_of_element_; // -1 for elements that are no cells
  std::vector<std::string> empty_;   // node sets without a side of a cell
};

class Exodus final : public MeshFormat
{
public:
  std::vector<std::string> endings() const override { return {".exo", ".ex2", ".e"}; }
  AnyMesh read(std::string const& file_name, ReadOptions const& options) const override
  {
    return ExodusFile(file_name, options).mesh();
  }
};
} // namespace

ASPERITY_REGISTER(MeshFormatRegistry, "Exodus", Exodus)
} // namespace asperity::geometry
