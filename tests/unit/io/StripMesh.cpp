#include "unit/io/Support.hpp"

#include <algorithm>
#include <map>

namespace asperity::test
{
namespace
{
using Facet = Mesh<2>::Facet;
using Cell = Mesh<2>::Cell;

struct WholeStrip
{
  std::vector<Point<2>> vertices; // by global id
  std::vector<Cell> cells;
  std::vector<Facet> base, surface;
};

WholeStrip wholeStrip(int num_base)
{
  WholeStrip strip;
  strip.vertices.resize(2 * num_base);
  const auto bottom = [&](int i) { return num_base - 1 - i; };
  const auto top = [&](int i) { return 2 * num_base - 1 - i; };
  for (int i = 0; i < num_base; ++i) {
    strip.vertices[bottom(i)] = {stripPosition(i, num_base), 0};
    strip.vertices[top(i)] = {stripPosition(i, num_base), 1};
  }
  for (int i = 0; i + 1 < num_base; ++i) {
    strip.cells.push_back({bottom(i), bottom(i + 1), top(i)});
    strip.cells.push_back({bottom(i + 1), top(i + 1), top(i)});
    strip.base.push_back({bottom(i), bottom(i + 1)});
    strip.surface.push_back({top(i + 1), top(i)});
  }
  return strip;
}

bool isOwned(int vertex) { return vertex % world()->getSize() == world()->getRank(); }

template <class Element>
std::vector<Element> touchingOwned(std::vector<Element> const& elements)
{
  std::vector<Element> mine;
  std::copy_if(elements.begin(), elements.end(), std::back_inserter(mine),
               [](Element const& element) {
                 return std::any_of(element.begin(), element.end(), isOwned);
               });
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
} // namespace

Mesh<2> stripMesh(int num_base)
{
  const WholeStrip strip = wholeStrip(num_base);
  Mesh<2> mesh;
  mesh.cells = touchingOwned(strip.cells);
  mesh.boundaries["base"] = touchingOwned(strip.base);
  mesh.boundaries["surface"] = touchingOwned(strip.surface);
  std::vector<int> ids;
  for (auto const& cell : mesh.cells) {
    ids.insert(ids.end(), cell.begin(), cell.end());
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const auto ghosts = std::stable_partition(ids.begin(), ids.end(), isOwned);
  mesh.num_owned = static_cast<int>(ghosts - ids.begin());
  mesh.num_global_vertices = 2 * num_base;
  std::map<int, int> local_of_global;
  for (const int id : ids) {
    local_of_global[id] = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(strip.vertices[id]);
    mesh.global_ids.push_back(id);
  }
  renumber(mesh.cells, local_of_global);
  for (auto& boundary : mesh.boundaries) {
    renumber(boundary.second, local_of_global);
  }
  mesh.cell_regions.assign(mesh.cells.size(), 0);
  mesh.region_names = {"body"};
  return mesh;
}
} // namespace asperity::test
