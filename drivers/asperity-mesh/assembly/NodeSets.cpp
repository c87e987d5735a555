#include "assembly/NodeSets.hpp"

#include "assembly/CellShape.hpp"

#include "base/Text.hpp"

#include <algorithm>
#include <iostream>
#include <map>

namespace asperity::geometry
{
bool addNodeSet(ForeignMesh& mesh, std::string const& name, std::vector<int> const& nodes)
{
  std::vector<bool> is_in(mesh.vertices.size(), false);
  for (int node : nodes) {
    is_in[static_cast<std::size_t>(node)] = true;
  }
  std::size_t whole_cells = 0;
  struct Found
  {
    ForeignMesh::Side side;
    int num_cells;
  };
  std::map<ForeignMesh::Side, Found> found; // by ascending corners
  for (auto const& cell : mesh.cells) {
    int num_in = 0;
    for (int i = 0; i < cell.num_corners; ++i) {
      num_in += is_in[static_cast<std::size_t>(cell.corners[i])] ? 1 : 0;
    }
    whole_cells += num_in == cell.num_corners ? 1 : 0;
    if (num_in < mesh.dimension) {
      continue;
    }
    for (auto const& places : sidesOf(mesh.dimension, cell.num_corners)) {
      std::vector<int> corners;
      for (int place : places) {
        corners.push_back(cell.corners[static_cast<std::size_t>(place)]);
      }
      if (std::all_of(corners.begin(), corners.end(),
                      [&](int corner) { return is_in[static_cast<std::size_t>(corner)]; })) {
        const auto side = ForeignMesh::side(corners);
        std::sort(corners.begin(), corners.end());
        ++found.emplace(ForeignMesh::side(corners), Found{side, 0}).first->second.num_cells;
      }
    }
  }
  const auto num_inside = static_cast<std::size_t>(std::count_if(
    found.begin(), found.end(), [](auto const& item) { return item.second.num_cells == 2; }));
  if (found.empty() || 8 * whole_cells > found.size()) {
    return false;
  }
  const bool is_inside = 2 * num_inside > found.size();
  auto& sides = mesh.group(name).sides;
  for (auto const& [corners, each] : found) {
    if ((each.num_cells == 2) == is_inside) {
      sides.push_back(each.side);
    }
  }
  return true;
}

void tellOfEmptySets(std::vector<std::string> const& names)
{
  if (!names.empty()) {
    std::cout << "sets of nodes that have no sides of cells, or whole cells, are left out: "
              << quotedNames(names) << '\n';
  }
}
} // namespace asperity::geometry
