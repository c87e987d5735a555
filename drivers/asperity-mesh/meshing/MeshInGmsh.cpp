#include "meshing/MeshInGmsh.hpp"

#include "gmsh/GmshSession.hpp"

#include "base/Errors.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cstddef>

namespace asperity::geometry
{
namespace
{
namespace model = gmsh::model;

// The tags of the corners of all elements of a type.
std::vector<std::size_t> elements(int dimension, int entity, int type)
{
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes;
  model::mesh::getElements(types, tags, nodes, dimension, entity);
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (types[i] == type) {
      return nodes[i];
    }
  }
  return {};
}
} // namespace

GlobalMesh<3> meshInGmsh(std::map<std::string, std::vector<int>> const& surfaces)
{
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, ignored;
  model::mesh::getNodes(tags, coordinates, ignored, -1, -1, false, false);
  const auto cells = elements(3, -1, type_tetrahedron);
  constexpr int no_cell = -2, unnumbered = -1;
  std::vector<int> number(tags.empty() ? 1 : *std::max_element(tags.begin(), tags.end()) + 1,
                          no_cell);
  for (std::size_t tag : cells) {
    number.at(tag) = unnumbered;
  }
  GlobalMesh<3> mesh;
  mesh.cells.reserve(cells.size() / 4);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if (number[tags[i]] == unnumbered) {
      number[tags[i]] = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back({coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]});
    }
  }
  for (std::size_t i = 0; i < cells.size(); i += 4) {
    auto& cell = mesh.cells.emplace_back();
    std::transform(&cells[i], &cells[i] + 4, cell.begin(), [&](auto tag) { return number[tag]; });
  }
  mesh.region_names = {"body"};
  mesh.cell_regions.assign(mesh.cells.size(), 0);
  for (auto const& [name, entities] : surfaces) {
    auto& facets = mesh.boundaries[name];
    for (int entity : entities) {
      const auto corners = elements(2, entity, type_triangle);
      for (std::size_t i = 0; i < corners.size(); i += 3) {
        auto& facet = facets.emplace_back();
        for (int k = 0; k < 3; ++k) {
          facet[k] = number.at(corners[i + k]);
          ASPERITY_REQUIRE(facet[k] >= 0, "Gmsh left a part of '"
                                            << name
                                            << "' out of the volume. Try another Cell "
                                               "Size, or a larger Snap.");
        }
      }
    }
  }
  return mesh;
}
} // namespace asperity::geometry
