#include "multigrid/Hierarchy.hpp"

#include "multigrid/Renumbering.hpp"

#include <utility>

namespace asperity::multigrid
{
namespace
{
struct Coloured
{
  std::vector<int> begins; // of the colours
  std::vector<int> row_of_node, coupling_of_given;
};

// Renumbers a level's rows colour by colour.
Coloured colourRows(HostLevel& level)
{
  auto [row_of_node, begins] = colour(level.graph);
  auto matrix = renumbered(level.graph, row_of_node, row_of_node);
  for (auto& term : level.terms) {
    term = renumbered(term, matrix.coupling_of_given, level.graph.blockSize());
  }
  for (int& coupling : level.added.couplings) {
    coupling = coupling < 0 ? coupling : matrix.coupling_of_given[coupling];
  }
  for (int& row : level.added.rows) {
    row = row_of_node[row];
  }
  level.graph = std::move(matrix.graph);
  return {std::move(begins), std::move(row_of_node), std::move(matrix.coupling_of_given)};
}

// The end and the beginning of each row's couplings with nodes before and after its own.
std::pair<std::vector<int>, std::vector<int>> besideDiagonal(HostGraph const& graph)
{
  std::vector<int> before, after;
  for (int row = 0; row < graph.num_rows; ++row) {
    int k = graph.first[row];
    while (k < graph.first[row + 1] && graph.columns[k] < row) {
      ++k;
    }
    before.push_back(k);
    after.push_back(k + (k < graph.first[row + 1] && graph.columns[k] == row ? 1 : 0));
  }
  return {before, after};
}

// Releases what it moves.
Level deviceLevel(HostLevel host, Schedule schedule)
{
  Level level;
  level.graph = NodeGraph(host.graph);
  for (auto& term : host.terms) {
    level.terms.push_back(onDevice(std::exchange(term, HostBlocks())));
  }
  auto const [before, after] = besideDiagonal(host.graph);
  level.before = onDevice(before);
  level.after = onDevice(after);
  if (!host.prolongation.first.empty()) {
    level.prolongation = NodeGraph(host.prolongation);
    level.P = onDevice(std::exchange(host.P, HostBlocks()));
    level.restriction = TransposedProduct(host.prolongation, schedule);
  }
  if (!host.added.first.empty()) {
    level.added = AddedBlocks(host.added, host.graph);
  }
  level.schedule = std::move(schedule);
  return level;
}
} // namespace

Hierarchy::Hierarchy(std::vector<HostLevel> levels, CoarsestRows coarsest, RowOrder order,
                     int num_threads)
    : coarsest_(std::move(coarsest))
{
  const bool has_colours = order == RowOrder::colours;
  std::vector<std::vector<int>> row_of_node(levels.size());
  std::vector<Schedule> schedules;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    auto& level = levels[l];
    if (!has_colours) {
      schedules.push_back(Schedule::inChunks(level.graph.first, num_threads));
    } else if (l + 1 == levels.size()) { // has no sweeps
      schedules.push_back(Schedule::inColours({0, level.graph.num_rows}));
    } else {
      auto coloured = colourRows(level);
      schedules.push_back(Schedule::inColours(std::move(coloured.begins)));
      row_of_node[l] = std::move(coloured.row_of_node);
      if (l == 0) {
        coupling_of_given_ = std::move(coloured.coupling_of_given);
        row_of_node_ = onDevice(row_of_node[0]);
      }
    }
  }
  levels_.reserve(levels.size());
  for (std::size_t l = 0; l < levels.size(); ++l) {
    auto level = std::exchange(levels[l], HostLevel());
    if (has_colours && l + 1 < levels.size()) {
      auto P = renumbered(level.prolongation, row_of_node[l], row_of_node[l + 1]);
      level.P = renumbered(level.P, P.coupling_of_given, level.prolongation.blockSize());
      level.prolongation = std::move(P.graph);
    }
    levels_.push_back(deviceLevel(std::move(level), std::move(schedules[l])));
  }
}

NodeBlocks Hierarchy::inOrder(HostBlocks const& finest) const
{
  auto const& graph = levels_.front().graph;
  return onDevice(coupling_of_given_.empty()
                    ? finest
                    : renumbered(finest, coupling_of_given_, graph.blockSize()));
}
} // namespace asperity::multigrid
