#include "assembly/CellShape.hpp"
#include "assembly/ForeignMesh.hpp"
#include "assembly/GroupNaming.hpp"
#include "assembly/NodeSets.hpp"
#include "formats/AbaqusDeck.hpp"
#include "formats/MeshFormat.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/GlobalMesh.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

// Abaqus's input file: *NODE, *ELEMENT, sets *NSET and *ELSET, *SURFACE of sides S1, S2 ..., and
// sections, whose sets of elements are regions.
namespace asperity::geometry
{
namespace
{
// Side S(K + 1) of a cell, as places among its corners.
std::vector<std::vector<int>> const& abaqusSides(int dimension, int num_corners)
{
  static const std::map<int, std::vector<std::vector<int>>> in_space = {
    {4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}},
    {5, {{0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}}},
    {6, {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}},
    {8, {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}}};
  return dimension == 3 ? in_space.at(num_corners) : sidesOf(dimension, num_corners);
}

class AbaqusMesh
{
public:
  AbaqusMesh(AbaqusDeck const& deck, ReadOptions const& options)
      : options_(options)
      , deck_(deck)
      , region_names_(options.names.regions, regions_option, "set", {})
      , boundary_names_(options.names.boundaries, boundaries_option, "set", {})
  {
  }

  AnyMesh mesh()
  {
    addVertices();
    addCells();
    addSurfaces();
    addShells();
    for (auto const& [key, set] : deck_.node_sets) {
      addNodes(set);
    }
    return mesh_.dimension == 2 ? AnyMesh(finished<2>()) : AnyMesh(finished<3>());
  }

private:
  template <int Dim>
  GlobalMesh<Dim> finished()
  {
    auto result = assemble<Dim>(mesh_, options_.assembly, deck_.where);
    region_names_.finish(deck_.where);
    boundary_names_.finish(deck_.where);
    tellOfEmptySets(empty_);
    return result;
  }

  void addVertices()
  {
    for (auto const& [number, place] : deck_.nodes) {
      position_[number] = static_cast<int>(mesh_.vertices.size());
      mesh_.numbers.push_back(number);
      mesh_.vertices.push_back(place);
    }
  }

  int positionOf(std::int64_t node, std::string const& user) const
  {
    const auto found = position_.find(node);
    ASPERITY_REQUIRE(found != position_.end(), deck_.where << ": " << user << " has node " << node
                                                           << ", which is not there.");
    return found->second;
  }

  std::vector<int> positions(std::vector<std::int64_t> const& nodes, std::string const& user) const
  {
    std::vector<int> result;
    for (auto node : nodes) {
      result.push_back(positionOf(node, user));
    }
    return result;
  }

  // The set of a section is the region, or the set of *ELEMENT, or else 'body'.
  std::map<std::int64_t, std::string> regions() const
  {
    std::map<std::int64_t, std::string> result;
    for (auto const& section : deck_.sections) {
      const auto found = deck_.element_sets.find(upperCase(section));
      if (found != deck_.element_sets.end()) {
        for (auto number : found->second.members) {
          result[number] = found->second.name;
        }
      }
    }
    return result;
  }

  void addCells()
  {
    const bool is_solid = std::any_of(deck_.elements.begin(), deck_.elements.end(),
                                      [](auto const& item) { return item.second.dimension == 3; });
    mesh_.dimension = is_solid ? 3 : 2;
    const auto region_of = regions();
    for (auto const& [number, element] : deck_.elements) {
      if (element.dimension != mesh_.dimension) {
        continue;
      }
      const auto what = "element " + std::to_string(number);
      const int corners = cornersOf(element, what);
      const auto section = region_of.find(number);
      const auto region = section != region_of.end() ? section->second
                          : element.set.empty()      ? "body"
                                                     : element.set;
      cell_of_[number] = static_cast<int>(mesh_.cells.size());
      mesh_.addCell(mesh_.region(region_names_.nameOf(region)), positions(element.nodes, what),
                    corners, number);
    }
    ASPERITY_REQUIRE(!mesh_.cells.empty(), deck_.where << " has no cells.");
  }

  int cornersOf(AbaqusDeck::Element const& element, std::string const& what) const
  {
    const auto count = static_cast<int>(std::min<std::size_t>(element.nodes.size(), 1000));
    const int corners =
      element.dimension == 1 ? std::min(count, 2) : cornersOfCell(element.dimension, count);
    ASPERITY_REQUIRE(corners > 1, deck_.where
                                    << ": " << what << " has " << count
                                    << " nodes. Only cells of first and, with --simplices, second "
                                       "order can be read.");
    return corners;
  }

  void addSurfaces()
  {
    for (auto const& surface : deck_.surfaces) {
      if (surface.is_of_nodes) {
        AbaqusDeck::Set all{surface.name, {}};
        for (auto const& [set, unused] : surface.sides) {
          const auto found = deck_.node_sets.find(upperCase(set));
          if (found != deck_.node_sets.end()) {
            auto const& members = found->second.members;
            all.members.insert(all.members.end(), members.begin(), members.end());
          }
        }
        addNodes(all);
        continue;
      }
      const auto name = boundary_names_.nameOf(surface.name);
      mesh_.group(name);
      for (auto const& [what, side] : surface.sides) {
        for (auto number : elementsOf(what, surface.name)) {
          addSide(name, number, side);
        }
      }
    }
  }

  std::vector<std::int64_t> elementsOf(std::string const& what, std::string const& surface) const
  {
    if (const auto number = readInteger(what)) {
      return {*number};
    }
    const auto found = deck_.element_sets.find(upperCase(what));
    ASPERITY_REQUIRE(found != deck_.element_sets.end(),
                     deck_.where << ": surface '" << surface << "' has '" << what
                                 << "', which is neither an element nor a set of elements.");
    return found->second.members;
  }

  void addSide(std::string const& name, std::int64_t number, std::string const& side)
  {
    const auto cell = cell_of_.find(number);
    const bool is_numbered = side.size() > 1 && side[0] == 'S';
    const int which = is_numbered ? readInteger(side.substr(1)).value_or(0) : 0;
    const bool is_cell = cell != cell_of_.end();
    const int corners =
      is_cell ? mesh_.cells[static_cast<std::size_t>(cell->second)].num_corners : 0;
    ASPERITY_REQUIRE(is_cell && which >= 1 &&
                       which <= static_cast<int>(abaqusSides(mesh_.dimension, corners).size()),
                     deck_.where << ": surface '" << name << "' has side '" << side
                                 << "' of element " << number
                                 << ". It needs sides S1, S2 ... of cells.");
    mesh_.addSide(name, cell->second,
                  abaqusSides(mesh_.dimension, corners)[static_cast<std::size_t>(which) - 1]);
  }

  // Sets of elements that are sides of cells.
  void addShells()
  {
    for (auto const& [key, set] : deck_.element_sets) {
      std::vector<ForeignMesh::Side> sides;
      for (auto number : set.members) {
        const auto element = deck_.elements.find(number);
        if (element != deck_.elements.end() && element->second.dimension == mesh_.dimension - 1) {
          const auto what = "element " + std::to_string(number);
          auto nodes = positions(element->second.nodes, what);
          nodes.resize(static_cast<std::size_t>(cornersOf(element->second, what)));
          sides.push_back(ForeignMesh::side(nodes));
        }
      }
      if (!sides.empty()) {
        auto& group = mesh_.group(boundary_names_.nameOf(set.name)).sides;
        group.insert(group.end(), sides.begin(), sides.end());
      }
    }
  }

  void addNodes(AbaqusDeck::Set const& set)
  {
    const auto name = boundary_names_.nameOf(set.name);
    if (!addNodeSet(mesh_, name, positions(set.members, "set '" + set.name + "'"))) {
      empty_.push_back(name);
    }
  }

  ReadOptions const& options_;
  AbaqusDeck const& deck_;
  GroupNaming region_names_, boundary_names_;
  std::map<std::int64_t, int> position_; // of a node in the mesh
  std::map<std::int64_t, int> cell_of_;  // of an element, where it is a cell
  ForeignMesh mesh_{3};
  std::vector<std::string> empty_; // sets without a side of a cell
};

class Abaqus final : public MeshFormat
{
public:
  std::vector<std::string> endings() const override { return {".inp"}; }
  AnyMesh read(std::string const& file_name, ReadOptions const& options) const override
  {
    const AbaqusDeck deck(file_name);
    return AbaqusMesh(deck, options).mesh();
  }
};
} // namespace

ASPERITY_REGISTER(MeshFormatRegistry, "Abaqus", Abaqus)
} // namespace asperity::geometry
