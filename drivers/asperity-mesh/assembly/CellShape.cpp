#include "assembly/CellShape.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace asperity::geometry
{
std::vector<std::vector<int>> const& sidesOf(int dimension, int num_corners)
{
  using Sides = std::vector<std::vector<int>>;
  static const std::map<std::pair<int, int>, Sides> sides = {
    {{2, 3}, {{0, 1}, {1, 2}, {2, 0}}},
    {{2, 4}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
    {{3, 4}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}},
    {{3, 5}, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}},
    {{3, 6}, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
    {{3, 8}, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}}};
  static const Sides none;
  const auto found = sides.find({dimension, num_corners});
  return found == sides.end() ? none : found->second;
}

int cornersOfCell(int dimension, int num_nodes)
{
  static const std::map<std::pair<int, int>, int> of_second_order = {
    {{2, 6}, 3},  {{2, 7}, 3},  {{2, 8}, 4},  {{2, 9}, 4},  {{3, 10}, 4}, {{3, 13}, 5},
    {{3, 14}, 5}, {{3, 15}, 6}, {{3, 18}, 6}, {{3, 20}, 8}, {{3, 27}, 8}};
  if (!sidesOf(dimension, num_nodes).empty()) {
    return num_nodes;
  }
  const auto found = of_second_order.find({dimension, num_nodes});
  return found == of_second_order.end() ? 0 : found->second;
}

std::string shapeName(int dimension, int num_corners)
{
  static const std::map<std::pair<int, int>, std::string> names = {
    {{2, 3}, "triangle"}, {{2, 4}, "quadrilateral"}, {{3, 4}, "tetrahedron"},
    {{3, 5}, "pyramid"},  {{3, 6}, "prism"},         {{3, 8}, "hexahedron"}};
  return names.at({dimension, num_corners});
}

std::vector<std::vector<int>> simplicesOf(int dimension, std::vector<int> const& corners)
{
  const auto is_simplex = static_cast<int>(corners.size()) == dimension + 1;
  if (is_simplex) {
    return std::set<int>(corners.begin(), corners.end()).size() == corners.size()
             ? std::vector<std::vector<int>>{corners}
             : std::vector<std::vector<int>>();
  }
  const int smallest = *std::min_element(corners.begin(), corners.end());
  std::vector<std::vector<int>> result;
  for (auto const& places : sidesOf(dimension, static_cast<int>(corners.size()))) {
    std::vector<int> side;
    for (int place : places) {
      side.push_back(corners[static_cast<std::size_t>(place)]);
    }
    if (std::find(side.begin(), side.end(), smallest) == side.end()) {
      for (auto& simplex : simplicesOf(dimension - 1, side)) {
        simplex.insert(simplex.begin(), smallest);
        result.push_back(std::move(simplex));
      }
    }
  }
  return result;
}
} // namespace asperity::geometry
