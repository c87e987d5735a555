#include "multigrid/Renumbering.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace asperity::multigrid
{
namespace
{
int numberOf(std::vector<int> const& numbers, int node)
{
  return node < static_cast<int>(numbers.size()) ? numbers[node] : node;
}

// part: (num_rows) of each node.
RowParts partsOf(std::vector<int> const& part, int num_parts)
{
  RowParts result;
  result.begins.assign(num_parts + 1, 0);
  for (int of_node : part) {
    ++result.begins[of_node + 1];
  }
  std::partial_sum(result.begins.begin(), result.begins.end(), result.begins.begin());
  auto next = result.begins;
  for (int of_node : part) {
    result.row_of_node.push_back(next[of_node]++);
  }
  return result;
}

class RegionsOfNodes
{
public:
  RegionsOfNodes(HostGraph const& graph, int count)
      : graph_(graph)
      , region_(graph.num_rows, 0)
      , reached_(graph.num_rows, 0)
  {
    std::vector<int> nodes(graph.num_rows);
    std::iota(nodes.begin(), nodes.end(), 0);
    split(nodes, 0, count);
  }

  std::vector<int> const& regions() const { return region_; } // of each node

private:
  int numCouplings(int node) const { return graph_.first[node + 1] - graph_.first[node]; }

  // Splits the region `first`, which has the nodes, into `count` regions from `first` on.
  void split(std::vector<int> const& nodes, int first, int count)
  {
    if (count == 1 || nodes.empty()) {
      return;
    }
    const auto near = byDistanceFrom(byDistanceFrom(nodes.front(), nodes).back(), nodes);
    std::int64_t left = 0; // couplings of the first half
    for (int node : nodes) {
      left += numCouplings(node);
    }
    left = left * (count / 2) / count;
    auto cut = near.begin();
    while (cut != near.end() && left > 0) {
      left -= numCouplings(*cut++);
    }
    const int second = first + count / 2;
    std::for_each(cut, near.end(), [&](int node) { region_[node] = second; });
    split({near.begin(), cut}, first, count / 2);
    split({cut, near.end()}, second, count - count / 2);
  }

  // The nodes of a region, those that are fewer couplings away from `start` first; pieces that are
  // not coupled with it follow.
  std::vector<int> byDistanceFrom(int start, std::vector<int> const& nodes)
  {
    ++search_;
    std::vector<int> order;
    const auto reach = [&](int node) {
      if (reached_[node] != search_) {
        reached_[node] = search_;
        order.push_back(node);
      }
    };
    std::size_t next = 0;
    const auto goOn = [&] {
      for (; next < order.size(); ++next) {
        const int node = order[next];
        for (int k = graph_.first[node]; k < graph_.first[node + 1]; ++k) {
          const int other = graph_.columns[k];
          if (other < graph_.num_rows && region_[other] == region_[start]) {
            reach(other);
          }
        }
      }
    };
    reach(start);
    goOn();
    for (int node : nodes) {
      reach(node);
      goOn();
    }
    return order;
  }

  HostGraph const& graph_;
  std::vector<int> region_, reached_;
  int search_ = 0;
};
} // namespace

RowParts colours(HostGraph const& graph)
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
  return partsOf(colours, static_cast<int>(taken_by.size()));
}

RowParts regions(HostGraph const& graph, int most)
{
  // A region of fewer rows costs more to start than it saves.
  constexpr int least_rows = 256;
  const int count = std::max(1, std::min(most, graph.num_rows / least_rows));
  return count == 1 ? RowParts{{}, {0, graph.num_rows}}
                    : partsOf(RegionsOfNodes(graph, count).regions(), count);
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
  if (graph.ghosts.renumbered) {
    const int size = graph.column_size;
    std::vector<int> numbers(static_cast<std::size_t>(graph.num_owned) * size);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const int column = static_cast<int>(k);
      numbers[k] = numberOf(column_of_node, column / size) * size + column % size;
    }
    result.graph.ghosts = graph.ghosts.renumbered(numbers);
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
