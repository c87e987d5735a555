#include "gmsh/GmshFile.hpp"

#include "Warnings.hpp"
#include "assembly/CellShape.hpp"
#include "assembly/GroupNames.hpp"
#include "gmsh/GmshSession.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"

#include <gmsh.h>

#include <cstdint>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <unordered_map>
#include <utility>
#include <vector>

namespace asperity::geometry
{
namespace model = gmsh::model;

namespace
{
using Tag = std::size_t;

// Gmsh reads any other text as a script and would run it.
void requireMeshFormat(std::string const& file_name, std::string const& where)
{
  std::ifstream file(file_name);
  ASPERITY_REQUIRE(file.is_open(), where << " cannot be opened. Is it there, and may you read it?");
  std::string line;
  std::getline(file, line);
  ASPERITY_REQUIRE(line.rfind("$MeshFormat", 0) == 0,
                   where << " is not a mesh of Gmsh: it does not begin with $MeshFormat.");
}

// The elements of one type of an entity: cells or sides of cells.
struct Elements
{
  int num_nodes = 0, num_corners = 0;
  std::vector<Tag> tags, nodes; // (number), (number) x (num_nodes)
};

std::vector<Elements> elementsOf(int dimension, int entity, std::string const& where)
{
  std::vector<int> types;
  std::vector<std::vector<Tag>> tags, nodes;
  model::mesh::getElements(types, tags, nodes, dimension, entity);
  std::vector<Elements> all;
  for (std::size_t i = 0; i < types.size(); ++i) {
    std::string name;
    int dim = 0, order = 0;
    std::vector<double> coordinates;
    Elements found;
    model::mesh::getElementProperties(types[i], name, dim, order, found.num_nodes, coordinates,
                                      found.num_corners);
    const bool is_known = dim < 2 || !sidesOf(dim, found.num_corners).empty();
    ASPERITY_REQUIRE(is_known && (order == 1 || order == 2) && dim >= 1,
                     where << " has cells of type '" << name << "', the first with tag "
                           << tags[i].front()
                           << ". Only cells of first and, with --simplices, second order can be "
                              "read.");
    found.tags = std::move(tags[i]);
    found.nodes = std::move(nodes[i]);
    all.push_back(std::move(found));
  }
  return all;
}

class Import
{
public:
  Import(PhysicalGroups const& groups, int dimension, std::string const& where)
      : groups_(groups)
      , where_(where)
      , mesh_(dimension)
  {
  }

  ForeignMesh run()
  {
    readVertices();
    readCells();
    readBoundaries();
    return std::move(mesh_);
  }

private:
  // In the order of their tags.
  void readVertices()
  {
    std::vector<Tag> tags;
    std::vector<double> xyz, parameters;
    model::mesh::getNodes(tags, xyz, parameters, -1, -1, false, false);
    std::map<Tag, double const*> coordinates;
    for (std::size_t i = 0; i < tags.size(); ++i) {
      coordinates[tags[i]] = &xyz[3 * i];
    }
    for (auto const& [tag, x] : coordinates) {
      position_[tag] = static_cast<int>(mesh_.vertices.size());
      mesh_.vertices.push_back({x[0], x[1], x[2]});
      mesh_.numbers.push_back(static_cast<std::int64_t>(tag));
    }
  }

  std::vector<int> positions(Tag const* tags, int number) const
  {
    std::vector<int> result;
    for (int i = 0; i < number; ++i) {
      const auto found = position_.find(tags[i]);
      ASPERITY_REQUIRE(found != position_.end(),
                       where_ << ": a cell has node " << tags[i] << ", which has no coordinates.");
      result.push_back(found->second);
    }
    return result;
  }

  void readCells()
  {
    std::map<int, std::string> region_of_entity;
    for (auto const& group : groups_.regions) {
      const int region = mesh_.region(group.name);
      for (int entity : group.entities) {
        if (region_of_entity.emplace(entity, group.name).second) {
          for (auto const& cells : elementsOf(mesh_.dimension, entity, where_)) {
            for (std::size_t i = 0; i < cells.tags.size(); ++i) {
              mesh_.addCell(region,
                            positions(&cells.nodes[i * static_cast<std::size_t>(cells.num_nodes)],
                                      cells.num_nodes),
                            cells.num_corners, static_cast<std::int64_t>(cells.tags[i]));
            }
          }
        }
      }
    }
    requireNamed(region_of_entity);
  }

  void requireNamed(std::map<int, std::string> const& region_of_entity) const
  {
    gmsh::vectorpair entities;
    model::getEntities(entities, mesh_.dimension);
    for (auto const& [dim, entity] : entities) {
      ASPERITY_REQUIRE(region_of_entity.count(entity) > 0 ||
                         elementsOf(dim, entity, where_).empty(),
                       where_ << ": " << entityName(dim) << " " << entity
                              << " has cells but is in no physical " << entityName(dim) << '.');
    }
  }

  // Format 2.2 repeats a facet for each group of its entity.
  void readBoundaries()
  {
    for (auto const& group : groups_.boundaries) {
      auto& sides = mesh_.group(group.name).sides;
      for (int entity : group.entities) {
        for (auto const& facets : elementsOf(mesh_.dimension - 1, entity, where_)) {
          const auto step = static_cast<std::size_t>(facets.num_nodes);
          for (std::size_t i = 0; i < facets.nodes.size(); i += step) {
            sides.push_back(ForeignMesh::side(positions(&facets.nodes[i], facets.num_corners)));
          }
        }
      }
    }
  }

  PhysicalGroups const& groups_;
  std::string const& where_;
  ForeignMesh mesh_;
  std::unordered_map<Tag, int> position_; // of the vertex with this tag
};

// The number of parts that the file says a partitioned mesh has; 0 if it does not say it.
std::size_t declaredParts(std::string const& file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  std::string line, format;
  std::getline(file, line);
  std::getline(file, format); // version, 1 if binary, size of a number
  while (std::getline(file, line) && line.rfind("$Nodes", 0) != 0) {
    if (line.rfind("$PartitionedEntities", 0) == 0) {
      std::size_t parts = 0;
      std::istringstream words(format);
      std::string version, is_binary;
      words >> version >> is_binary;
      is_binary == "1" ? file.read(reinterpret_cast<char*>(&parts), sizeof parts) : file >> parts;
      return parts;
    }
  }
  return 0;
}

// Puts the parts of a mesh that Gmsh has partitioned together again: pieces of a region or a
// boundary are entities without a name of their own.
void joinParts(std::string const& file_name, std::string const& where)
{
  gmsh::vectorpair entities;
  model::getEntities(entities);
  std::set<int> parts;
  for (auto const& [dim, entity] : entities) {
    std::vector<int> of_entity;
    model::getPartitions(dim, entity, of_entity);
    if (of_entity.size() == 1) { // with more it lies between parts
      parts.insert(of_entity.front());
    }
  }
  if (parts.empty()) {
    return;
  }
  const auto declared = declaredParts(file_name);
  const auto number = declared > 0 ? declared : static_cast<std::size_t>(*parts.rbegin());
  ASPERITY_REQUIRE(
    parts.size() == number && (declared > 0 || number > 1),
    where << " is a part of a mesh that Gmsh has partitioned, and the others are not "
             "in this file. Save the mesh whole, with Mesh.PartitionSplitMeshFiles "
             "= 0 or before it is partitioned.");
  model::mesh::unpartition();
  std::cout << where << " is partitioned by Gmsh; its " << number
            << " parts are put together. asperity-mesh partition divides a mesh for ranks.\n";
}

// The dimensions of the physical groups that have a name in the file, whether they have cells or
// not. This section is text in all formats.
std::set<int> namedDimensions(std::string const& file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  std::set<int> dimensions;
  for (std::string line; std::getline(file, line) && line.rfind("$Nodes", 0) != 0;) {
    if (line.rfind("$PhysicalNames", 0) == 0) {
      std::getline(file, line); // their number
      while (std::getline(file, line) && line.rfind("$End", 0) != 0) {
        dimensions.insert(std::atoi(line.c_str()));
      }
    }
  }
  return dimensions;
}

void requireGroupsOfNames(std::string const& file_name, int dimension, std::string const& where)
{
  const auto named = namedDimensions(file_name);
  for (int group_dimension : {dimension, dimension - 1}) {
    gmsh::vectorpair groups;
    model::getPhysicalGroups(groups, group_dimension);
    ASPERITY_REQUIRE(!groups.empty() || named.count(group_dimension) == 0,
                     where << " has names of physical " << entityName(group_dimension)
                           << "s, but nothing in "
                           << "the mesh belongs to one. Gmsh loses the groups with Mesh.SaveAll = "
                              "1 in format 2.2: save the mesh with Mesh.SaveAll = 0, or with "
                              "Mesh.MshFileVersion = 4.1.");
  }
}

// Prints Gmsh's warnings, without the start of its own.
void forwardWarnings(std::string const& where)
{
  std::vector<std::string> lines;
  gmsh::logger::get(lines);
  const std::string start = "Warning: ";
  for (auto const& line : lines) {
    if (line.rfind(start, 0) == 0) {
      warn(where + ": Gmsh says: " + line.substr(start.size()));
    }
  }
}
} // namespace

GmshFile::GmshFile(std::string const& file_name, std::string where, GroupNames const& names)
    : where_(std::move(where))
    , session_(false)
{
  requireMeshFormat(file_name, where_);
  gmsh::logger::start();
  session_.open(file_name, where_);
  forwardWarnings(where_);
  joinParts(file_name, where_);
  requireGroupsOfNames(file_name, dimension(), where_);
  groups_ = physicalGroups(dimension(), names, where_);
}

int GmshFile::dimension() const
{
  std::vector<int> types;
  model::mesh::getElementTypes(types, 3);
  return types.empty() ? 2 : 3;
}

template <int Dim>
GlobalMesh<Dim> GmshFile::mesh(AssemblyOptions const& options) const
{
  return assemble<Dim>(Import(groups_, Dim, where_).run(), options, where_);
}

template GlobalMesh<2> GmshFile::mesh(AssemblyOptions const&) const;
template GlobalMesh<3> GmshFile::mesh(AssemblyOptions const&) const;
} // namespace asperity::geometry
