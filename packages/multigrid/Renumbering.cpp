#include "multigrid/Renumbering.hpp"

#include <algorithm>
#include <numeric>

namespace asperity::multigrid
{
namespace
{
int numberOf(std::vector<int> const& numbers, int node)
{
  return node < static_cast<int>(numbers.size()) ? numbers[node] : node;
}
} // namespace

Colours colour(HostGraph const& graph)
{
  std::vector<int> colours(graph.num_rows, -1), taken_by;
  for (int node = 0; node < graph.num_rows; ++node) {
    for (int k = graph.first[node]; k < graph.first[node + 1]; ++k) {
      const int other = graph.columns[k];
      if (other < graph.num_rows && colours[other] >= 0) {
        taken_by[colours[other]] = node;
      }
    }
    const auto free =
      std::find_if(taken_by.begin(), taken_by.end(), [&](int taker) { return taker != node; });
    colours[node] = static_cast<int>(free - taken_by.begin());
    if (free == taken_by.end()) {
      taken_by.push_back(-1);
    }
  }
  Colours result;
  result.begins.assign(taken_by.size() + 1, 0);
  for (int of_node : colours) {
    ++result.begins[of_node + 1];
  }
  std::partial_sum(result.begins.begin(), result.begins.end(), result.begins.begin());
  auto next = result.begins;
  for (int of_node : colours) {
    result.row_of_node.push_back(next[of_node]++);
  }
  return result;
}

Renumbered renumbered(HostGraph const& graph, std::vector<int> const& row_of_node,
                      std::vector<int> const& column_of_node)
{
  Renumbered result;
  result.graph = graph;
  result.coupling_of_given.resize(graph.columns.size());
  std::vector<int> node_of_row(graph.num_rows);
  for (int node = 0; node < graph.num_rows; ++node) {
    node_of_row[numberOf(row_of_node, node)] = node;
  }
  std::vector<int> order; // the given couplings of a row by their new columns
  int next = 0;
  for (int row = 0; row < graph.num_rows; ++row) {
    const int node = node_of_row[row];
    order.resize(graph.first[node + 1] - graph.first[node]);
    std::iota(order.begin(), order.end(), graph.first[node]);
    const auto column = [&](int k) { return numberOf(column_of_node, graph.columns[k]); };
    std::sort(order.begin(), order.end(), [&](int k, int l) { return column(k) < column(l); });
    for (int k : order) {
      result.coupling_of_given[k] = next;
      result.graph.columns[next++] = column(k);
    }
    result.graph.first[row + 1] = next;
  }
  for (int& sent : result.graph.ghosts.sent) {
    const int size = graph.column_size;
    sent = numberOf(column_of_node, sent / size) * size + sent % size;
  }
  return result;
}

HostBlocks renumbered(HostBlocks const& blocks, std::vector<int> const& coupling_of_given, int size)
{
  const auto result = makeNumbers<HostBlocks>(blocks.extent(0));
  for (std::size_t k = 0; k < coupling_of_given.size(); ++k) {
    std::copy_n(blocks.data() + k * size, size,
                result.data() + static_cast<std::size_t>(coupling_of_given[k]) * size);
  }
  return result;
}
} // namespace asperity::multigrid
