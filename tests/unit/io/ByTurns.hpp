#pragma once

#include "mesh/GlobalMesh.hpp"
#include "unit/io/Support.hpp"

#include <algorithm>
#include <map>

namespace asperity::test
{
inline bool isOwned(int vertex) { return vertex % world()->getSize() == world()->getRank(); }

template <class Element>
std::vector<Element> touchingOwned(std::vector<Element> const& elements)
{
  std::vector<Element> mine;
  std::copy_if(
    elements.begin(), elements.end(), std::back_inserter(mine),
    [](Element const& element) { return std::any_of(element.begin(), element.end(), isOwned); });
  return mine;
}

template <class Element>
void renumber(std::vector<Element>& elements, std::map<int, int> const& local_of_global)
{
  for (auto& element : elements) {
    for (int& vertex : element) {
      vertex = local_of_global.at(vertex);
    }
  }
}

// This rank's part of a mesh of one region whose vertices the ranks own by turns.
template <int Dim>
Mesh<Dim> byTurns(GlobalMesh<Dim> const& whole)
{
  Mesh<Dim> mesh;
  mesh.period = whole.period;
  mesh.cells = touchingOwned(whole.cells);
  std::vector<int> ids;
  for (auto const& cell : mesh.cells) {
    ids.insert(ids.end(), cell.begin(), cell.end());
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const auto ghosts = std::stable_partition(ids.begin(), ids.end(), isOwned);
  mesh.num_owned = static_cast<int>(ghosts - ids.begin());
  mesh.num_global_vertices = static_cast<GlobalOrdinal>(whole.vertices.size());
  std::map<int, int> local_of_global;
  for (const int id : ids) {
    local_of_global[id] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(whole.vertices[id]);
    mesh.global_ids.push_back(id);
  }
  renumber(mesh.cells, local_of_global);
  for (auto const& [name, facets] : whole.boundaries) {
    mesh.boundaries[name] = touchingOwned(facets);
    renumber(mesh.boundaries[name], local_of_global);
  }
  mesh.cell_regions.assign(mesh.cells.size(), 0);
  mesh.region_names = {"body"};
  return mesh;
}
} // namespace asperity::test
