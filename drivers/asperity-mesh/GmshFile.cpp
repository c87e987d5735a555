#include "GmshFile.hpp"

#include "GmshGeometry.hpp"

#include "base/Errors.hpp"
#include "base/Text.hpp"
#include "mesh/SimplexGeometry.hpp"

#include <gmsh.h>

#include <fstream>
#include <set>
#include <unordered_map>

using asperity::GlobalMesh;
using asperity::InputError;
using asperity::Point;
namespace model = gmsh::model;

namespace
{
using Tag = std::size_t;

// The names are those of Gmsh's own interface.
char const* entityName(int dimension)
{
  constexpr char const* names[] = {"Point", "Curve", "Surface", "Volume"};
  return names[dimension];
}

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

struct Group
{
  std::string name;
  std::vector<int> entities;
};

std::vector<Group> physicalGroups(int dimension, std::string const& where)
{
  gmsh::vectorpair tags;
  model::getPhysicalGroups(tags, dimension);
  std::vector<Group> groups;
  for (auto const& [dim, tag] : tags) {
    Group group;
    model::getPhysicalName(dim, tag, group.name);
    model::getEntitiesForPhysicalGroup(dim, tag, group.entities);
    ASPERITY_REQUIRE(!group.name.empty(), where << ": physical " << entityName(dim) << " " << tag
                                                << " has no name. In Gmsh's script: Physical "
                                                << entityName(dim) << "(\"name\", " << tag
                                                << ") = {...};");
    groups.push_back(group);
  }
  ASPERITY_REQUIRE(!groups.empty(), where << " has no physical " << entityName(dimension)
                                          << ". Regions and boundaries get their names from them: "
                                          << "Physical " << entityName(dimension)
                                          << "(\"name\") = {...};");
  return groups;
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
  explicit Import(std::string const& where) : where_(where) {}

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
    for (auto const& group : physicalGroups(Dim, where_)) {
      const int region = regionNumber(group.name);
      for (int entity : group.entities) {
        const auto [known, is_new] = region_of_entity.emplace(entity, group.name);
        ASPERITY_REQUIRE(is_new || known->second == group.name,
                         where_ << ": " << entityName(Dim) << " " << entity
                                << " is in two regions, '" << known->second << "' and '"
                                << group.name << "'.");
        if (is_new) {
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
      std::copy_n(found->second, Dim, mesh_.vertices.emplace_back().begin());
      size = std::max(size,
                      asperity::mesh::distance<Dim>(mesh_.vertices.back(), mesh_.vertices.front()));
    }
    for (std::size_t i = 0; i < cell_vertices_.size(); i += Dim + 1) {
      mesh_.cells.push_back(simplex<Dim + 1>(&cell_vertices_[i]));
    }
    for (Tag tag : used) {
      const double z = Dim == 2 ? coordinates.at(tag)[2] : 0;
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
    for (auto const& group : physicalGroups(Dim - 1, where_)) {
      auto& facets = mesh_.boundaries[group.name];
      for (int entity : group.entities) {
        const auto vertices = simplices(Dim - 1, entity, where_);
        for (Tag tag : vertices) {
          ASPERITY_REQUIRE(number_.count(tag) > 0, where_ << ": boundary '" << group.name
                                                          << "' has node " << tag
                                                          << ", which belongs to no cell.");
        }
        for (std::size_t i = 0; i < vertices.size(); i += Dim) {
          facets.push_back(simplex<Dim>(&vertices[i]));
        }
      }
    }
  }

  std::string const& where_;
  GlobalMesh<Dim> mesh_;
  std::vector<Tag> cell_vertices_;      // (num_cells) x (Dim + 1), Gmsh's tags
  std::unordered_map<Tag, int> number_; // of the vertex with this tag
};
} // namespace

GmshFile::GmshFile(std::string const& file_name, std::vector<std::string> const& settings)
    : where_((isGeometry(file_name) ? "Gmsh geometry '" : "Mesh file '") + file_name + "'")
{
  std::vector<std::string> arguments = {"gmsh"};
  if (isGeometry(file_name)) {
    for (auto const& [name, value] : readConstants(file_name, settings)) {
      arguments.insert(arguments.end(), {"-setnumber", name, asperity::formatNumber(value)});
    }
  } else {
    requireMeshFormat(file_name, where_);
    ASPERITY_REQUIRE(settings.empty(), "Option --set " << settings.front() << ": " << where_
                                                       << " is no geometry (.geo), but a mesh.");
  }
  std::vector<char*> words;
  for (auto& argument : arguments) {
    words.push_back(argument.data());
  }
  constexpr bool read_configuration = false;
  gmsh::initialize(static_cast<int>(words.size()), words.data(), read_configuration);
  gmsh::option::setNumber("General.Terminal", 0);
  try {
    const auto error = errorOfGmsh([&] { gmsh::open(file_name); });
    ASPERITY_REQUIRE(error.empty(), where_ << " cannot be read by Gmsh: " << error << ".");
    if (isGeometry(file_name)) {
      meshGeometry(where_);
    }
  } catch (...) {
    gmsh::finalize();
    throw;
  }
}

GmshFile::~GmshFile() { gmsh::finalize(); }

int GmshFile::dimension() const
{
  std::vector<int> types;
  model::mesh::getElementTypes(types, 3);
  return types.empty() ? 2 : 3;
}

template <int Dim>
GlobalMesh<Dim> GmshFile::mesh() const
{
  return Import<Dim>(where_).run();
}

template GlobalMesh<2> GmshFile::mesh() const;
template GlobalMesh<3> GmshFile::mesh() const;
