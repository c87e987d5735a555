#include "multigrid/Hierarchy.hpp"

#include "multigrid/Renumbering.hpp"

#include <numeric>
#include <utility>

namespace asperity::multigrid
{
namespace
{
// Renumbers a level's rows; returns for each coupling the place of the given one.
std::vector<int> renumberRows(HostLevel& level, std::vector<int> const& row_of_node)
{
  auto matrix = renumbered(level.graph, row_of_node, row_of_node);
  auto const& coupling_of_given = matrix.coupling_of_given;
  for (auto& term : level.terms) {
    term = renumbered(term, coupling_of_given, level.graph.blockSize());
  }
  for (int& coupling : level.added.couplings) {
    coupling = coupling < 0 ? coupling : coupling_of_given[coupling];
  }
  for (int& row : level.added.rows) {
    row = row_of_node[row];
  }
  const auto ids = level.ids;
  for (std::size_t node = 0; node < ids.size(); ++node) {
    level.ids[row_of_node[node]] = ids[node];
  }
  level.graph = std::move(matrix.graph);
  return std::move(matrix.coupling_of_given);
}

// order: of MatrixGraph. Releases what it copies.
Level deviceLevel(HostLevel host, std::vector<int> const& order, Schedule schedule)
{
  Level level;
  level.graph = MatrixGraph(host.graph);
  for (auto& term : host.terms) {
    level.terms.push_back(
      onDevice(renumbered(std::exchange(term, HostBlocks()), order, host.graph.blockSize())));
  }
  if (!host.prolongation.first.empty()) {
    level.prolongation = NodeGraph(host.prolongation);
    level.P = onDevice(std::exchange(host.P, HostBlocks()));
    level.restriction = TransposedProduct(host.prolongation, schedule);
  }
  if (!host.added.first.empty()) {
    level.added = AddedBlocks(host.added, host.graph, order);
  }
  level.schedule = std::move(schedule);
  level.ids = indices(host.ids);
  return level;
}
} // namespace

Hierarchy::Hierarchy(std::vector<HostLevel> levels, CoarsestRows coarsest, RowOrder order,
                     int num_threads)
    : coarsest_(std::move(coarsest))
{
  std::vector<std::vector<int>> row_of_node(levels.size()), couplings(levels.size());
  std::vector<Schedule> schedules;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    auto& graph = levels[l].graph;
    const bool has_sweeps = l + 1 < levels.size();
    if (levels[l].ids.empty()) {
      levels[l].ids.resize(graph.num_rows);
      std::iota(levels[l].ids.begin(), levels[l].ids.end(), 0);
    }
    auto parts = !has_sweeps                 ? RowParts{{}, {0, graph.num_rows}}
                 : order == RowOrder::chunks ? regions(graph, num_threads)
                                             : colours(graph);
    if (!parts.row_of_node.empty()) {
      couplings[l] = renumberRows(levels[l], parts.row_of_node);
    }
    row_of_node[l] = std::move(parts.row_of_node);
    schedules.emplace_back(order, std::move(parts.begins));
  }
  row_of_node_ = indices(row_of_node.front());
  levels_.reserve(levels.size());
  for (std::size_t l = 0; l < levels.size(); ++l) {
    auto level = std::exchange(levels[l], HostLevel());
    const bool is_renumbered =
      l + 1 < levels.size() && !(row_of_node[l].empty() && row_of_node[l + 1].empty());
    if (is_renumbered) {
      auto P = renumbered(level.prolongation, row_of_node[l], row_of_node[l + 1]);
      level.P = renumbered(level.P, P.coupling_of_given, level.prolongation.blockSize());
      level.prolongation = std::move(P.graph);
    }
    auto places = MatrixGraph::order(level.graph);
    levels_.push_back(deviceLevel(std::move(level), places, std::move(schedules[l])));
    if (l == 0) {
      for (int& coupling : couplings[0]) {
        coupling = places[coupling];
      }
      coupling_of_given_ = couplings[0].empty() ? std::move(places) : std::move(couplings[0]);
    }
  }
}

NodeBlocks Hierarchy::inOrder(HostBlocks const& finest) const
{
  return onDevice(renumbered(finest, coupling_of_given_, levels_.front().graph.blockSize()));
}
} // namespace asperity::multigrid
