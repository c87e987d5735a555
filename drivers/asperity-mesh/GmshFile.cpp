#include "GmshFile.hpp"

#include "GmshSession.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <gmsh.h>

#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <unordered_map>

using asperity::GlobalMesh;
using asperity::InputError;
using asperity::Point;
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

// Vertices of the simplices of an entity, (num_simplices) x (dimension + 1).
std::vector<Tag> simplices(int dimension, int entity, std::string const& where)
{
  const int wanted = std::array<int, 4>{15, 1, 2, 4}[dimension]; // Gmsh's linear simplices
  std::vector<int> types;
  std::vector<std::vector<Tag>> tags, vertices;
  model::mesh::getElements(types, tags, vertices, dimension, entity);
  std::vector<Tag> all;
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (types[i] != wanted) {
      std::string name;
      int dim = 0, order = 0, num_nodes = 0, num_primary = 0;
      std::vector<double> coordinates;
      model::mesh::getElementProperties(types[i], name, dim, order, num_nodes, coordinates,
                                        num_primary);
      throw InputError(where + " has cells of type '" + name + "', the first with tag " +
                       std::to_string(tags[i].front()) +
                       ". Only triangles and tetrahedra of first order can be read.");
    }
    all.insert(all.end(), vertices[i].begin(), vertices[i].end());
  }
  return all;
}

template <int Dim>
class Import
{
public:
  Import(PhysicalGroups const& groups, double scale, std::string const& where)
      : groups_(groups)
      , scale_(scale)
      , where_(where)
  {
  }

  GlobalMesh<Dim> run()
  {
    readCells();
    readVertices();
    readBoundaries();
    asperity::mesh::orientCells(mesh_);
    asperity::mesh::orientFacets(mesh_);
    asperity::mesh::checkMesh(mesh_, where_);
    return mesh_;
  }

private:
  void readCells()
  {
    std::map<int, std::string> region_of_entity;
    for (auto const& group : groups_.regions) {
      const int region = regionNumber(group.name);
      for (int entity : group.entities) {
        if (region_of_entity.emplace(entity, group.name).second) {
          const auto vertices = simplices(Dim, entity, where_);
          cell_vertices_.insert(cell_vertices_.end(), vertices.begin(), vertices.end());
          mesh_.cell_regions.insert(mesh_.cell_regions.end(), vertices.size() / (Dim + 1), region);
        }
      }
    }
    requireNamed(region_of_entity);
  }

  void requireNamed(std::map<int, std::string> const& region_of_entity) const
  {
    gmsh::vectorpair entities;
    model::getEntities(entities, Dim);
    for (auto const& [dim, entity] : entities) {
      ASPERITY_REQUIRE(region_of_entity.count(entity) > 0 || simplices(dim, entity, where_).empty(),
                       where_ << ": " << entityName(dim) << " " << entity
                              << " has cells but is in no physical " << entityName(dim) << '.');
    }
  }

  int regionNumber(std::string const& name)
  {
    auto& names = mesh_.region_names;
    const auto found = std::find(names.begin(), names.end(), name);
    const auto number = static_cast<int>(found - names.begin());
    if (found == names.end()) {
      names.push_back(name);
    }
    return number;
  }

  // Only vertices of cells are kept: Gmsh's files also hold the points from which lines and arcs
  // were made.
  void readVertices()
  {
    std::vector<Tag> tags;
    std::vector<double> xyz, parameters;
    model::mesh::getNodes(tags, xyz, parameters, -1, -1, false, false);
    std::unordered_map<Tag, double const*> coordinates;
    for (std::size_t i = 0; i < tags.size(); ++i) {
      coordinates[tags[i]] = &xyz[3 * i];
    }
    const std::set<Tag> used(cell_vertices_.begin(), cell_vertices_.end());
    double size = 0;
    for (Tag tag : used) {
      const auto found = coordinates.find(tag);
      ASPERITY_REQUIRE(found != coordinates.end(),
                       where_ << ": a cell has node " << tag << ", which has no coordinates.");
      number_[tag] = static_cast<int>(mesh_.vertices.size());
      std::transform(found->second, found->second + Dim, mesh_.vertices.emplace_back().begin(),
                     [this](double x) { return scale_ * x; });
      size = std::max(size,
                      asperity::mesh::distance<Dim>(mesh_.vertices.back(), mesh_.vertices.front()));
    }
    for (std::size_t i = 0; i < cell_vertices_.size(); i += Dim + 1) {
      mesh_.cells.push_back(simplex<Dim + 1>(&cell_vertices_[i]));
    }
    for (Tag tag : used) {
      const double z = Dim == 2 ? scale_ * coordinates.at(tag)[2] : 0;
      ASPERITY_REQUIRE(std::abs(z) <= 1e-9 * size,
                       where_ << ": node " << tag << " has z = " << z
                              << ". A two-dimensional mesh lies in the plane z = 0.");
    }
  }

  template <std::size_t N>
  std::array<int, N> simplex(Tag const* tags) const
  {
    std::array<int, N> vertices;
    std::transform(tags, tags + N, vertices.begin(), [&](Tag tag) { return number_.at(tag); });
    return vertices;
  }

  void readBoundaries()
  {
    for (auto const& group : groups_.boundaries) {
      auto& facets = mesh_.boundaries[group.name];
      std::set<std::array<Tag, Dim>> known; // by ascending tags
      for (int entity : group.entities) {
        const auto vertices = simplices(Dim - 1, entity, where_);
        for (std::size_t i = 0; i < vertices.size(); i += Dim) {
          std::array<Tag, Dim> sorted;
          std::copy_n(&vertices[i], Dim, sorted.begin());
          std::sort(sorted.begin(), sorted.end());
          if (known.insert(sorted).second) { // format 2.2 repeats it for each group of its entity
            requireSide(group.name, &vertices[i]);
            facets.push_back(simplex<Dim>(&vertices[i]));
          }
        }
      }
    }
  }

  // Gmsh meshes a curve or a surface that is not embedded for itself.
  void requireSide(std::string const& boundary, Tag const* vertices) const
  {
    for (Tag const* tag = vertices; tag != vertices + Dim; ++tag) {
      ASPERITY_REQUIRE(
        number_.count(*tag) > 0,
        where_ << ": the facets of '" << boundary << "' are not sides of cells: its "
               << "node " << *tag << " belongs to no cell. In Gmsh, embed it: "
               << (Dim == 2 ? "Curve{...} In Surface{...};" : "Surface{...} In Volume{...};")
               << " Or cut the body along it with BooleanFragments.");
    }
  }

  PhysicalGroups const& groups_;
  double scale_;
  std::string const& where_;
  GlobalMesh<Dim> mesh_;
  std::vector<Tag> cell_vertices_;      // (num_cells) x (Dim + 1), Gmsh's tags
  std::unordered_map<Tag, int> number_; // of the vertex with this tag
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
  for (int of : {dimension, dimension - 1}) {
    gmsh::vectorpair groups;
    model::getPhysicalGroups(groups, of);
    ASPERITY_REQUIRE(!groups.empty() || named.count(of) == 0,
                     where << " has names of physical " << entityName(of) << "s, but nothing in "
                           << "the mesh belongs to one. Gmsh loses the groups with Mesh.SaveAll = "
                              "1 in format 2.2: save the mesh with Mesh.SaveAll = 0, or with "
                              "Mesh.MshFileVersion = 4.1.");
  }
}

// Prints Gmsh's warnings, without the start of its own.
void passWarningsOn(std::string const& where)
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

GmshFile::GmshFile(std::string const& file_name, std::string where, GroupNames const& names,
                   double scale)
    : where_(std::move(where))
    , scale_(scale)
    , session_(false)
{
  requireMeshFormat(file_name, where_);
  gmsh::logger::start();
  session_.open(file_name, where_);
  passWarningsOn(where_);
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
GlobalMesh<Dim> GmshFile::mesh() const
{
  return Import<Dim>(groups_, scale_, where_).run();
}

template GlobalMesh<2> GmshFile::mesh() const;
template GlobalMesh<3> GmshFile::mesh() const;
