#include "tnnmg/hierarchy/NodeGraphs.hpp"

#include "base/Errors.hpp"
#include "base/parallel/GhostExchange.hpp"
#include "base/parallel/Reductions.hpp"
#include "base/program/WorkTimers.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace asperity::tnnmg::detail
{
using multigrid::HostBlocks;
using multigrid::HostGraph;

namespace
{
multigrid::ColumnExchange injected(GhostExchange const& exchange)
{
  auto const kept = std::make_shared<const GhostExchange>(exchange);
  return {[kept](multigrid::NodeVector const& x) {
            ASPERITY_NAME_WORK("V-cycles");
            kept->share<float>(x);
          },
          [kept](multigrid::NodeVector const& x) {
            ASPERITY_NAME_WORK("V-cycles");
            kept->gather<float>(x, 1, x);
          },
          [kept](std::vector<int> const& number) { return injected(kept->renumbered(number)); }};
}

// The owned and ghost nodes of the columns of matrices, as a map of single columns.
RCP<const Map> columnMap(std::vector<RCP<const CrsMatrix>> const& matrices, Map const& domain,
                         int size)
{
  std::vector<GlobalOrdinal> ghosts;
  for (auto const& matrix : matrices) {
    auto const& columns = *matrix->getColMap();
    for (LocalOrdinal k = 0; k < static_cast<LocalOrdinal>(numLocalElements(columns)); ++k) {
      const auto id = columns.getGlobalElement(k);
      if (!domain.isNodeGlobalElement(id)) {
        ghosts.push_back(id / size);
      }
    }
  }
  std::sort(ghosts.begin(), ghosts.end());
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  std::vector<GlobalOrdinal> ids;
  ids.reserve(numLocalElements(domain) + ghosts.size() * static_cast<std::size_t>(size));
  for (LocalOrdinal k = 0; k < static_cast<LocalOrdinal>(numLocalElements(domain)); ++k) {
    ids.push_back(domain.getGlobalElement(k));
  }
  for (auto ghost : ghosts) {
    for (int c = 0; c < size; ++c) {
      ids.push_back(ghost * size + c);
    }
  }
  const auto num_global = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return rcp(new Map(num_global, Teuchos::arrayViewFromVector(ids), 0, domain.getComm()));
}

// The local node and component of each column of a matrix, as node * size + component.
std::vector<int> placesOfColumns(NodeMaps const& maps, CrsMatrix const& matrix)
{
  auto const& from = *matrix.getColMap();
  std::vector<int> places(numLocalElements(from));
  for (std::size_t k = 0; k < places.size(); ++k) {
    places[k] = maps.columns->getLocalElement(from.getGlobalElement(static_cast<LocalOrdinal>(k)));
  }
  return places;
}
} // namespace

MappedGraph makeNodeGraph(std::vector<RCP<const CrsMatrix>> const& matrices, int row_size,
                          int column_size)
{
  MappedGraph result;
  auto& [graph, maps] = result;
  maps.rows = matrices.front()->getRowMap();
  maps.domain = maps.columns = matrices.front()->getDomainMap();
  graph.row_size = row_size;
  graph.column_size = column_size;
  graph.num_rows = static_cast<int>(numLocalElements(*maps.rows)) / row_size;
  graph.num_owned = static_cast<int>(numLocalElements(*maps.domain)) / column_size;
  if (maps.rows->getComm()->getSize() > 1) {
    maps.columns = columnMap(matrices, *maps.domain, column_size);
    std::vector<GlobalOrdinal> ghosts;
    for (auto k = numLocalElements(*maps.domain); k < numLocalElements(*maps.columns); ++k) {
      ghosts.push_back(maps.columns->getGlobalElement(static_cast<LocalOrdinal>(k)));
    }
    graph.ghosts = injected(GhostExchange(*maps.domain, ghosts));
  }
  graph.num_columns = static_cast<int>(numLocalElements(*maps.columns)) / column_size;
  std::vector<std::vector<int>> places;
  places.reserve(matrices.size());
  for (auto const& matrix : matrices) {
    places.push_back(placesOfColumns(maps, *matrix));
  }
  graph.first = {0};
  std::vector<int> row_columns;
  for (int row = 0; row < graph.num_rows; ++row) {
    row_columns.clear();
    for (std::size_t m = 0; m < matrices.size(); ++m) {
      auto const local = matrices[m]->getLocalMatrixHost();
      for (int r = row * row_size; r < (row + 1) * row_size; ++r) {
        for (auto k = local.graph.row_map(r); k < local.graph.row_map(r + 1); ++k) {
          row_columns.push_back(places[m][local.graph.entries(k)] / column_size);
        }
      }
    }
    std::sort(row_columns.begin(), row_columns.end());
    row_columns.erase(std::unique(row_columns.begin(), row_columns.end()), row_columns.end());
    graph.columns.insert(graph.columns.end(), row_columns.begin(), row_columns.end());
    graph.first.push_back(static_cast<int>(graph.columns.size()));
  }
  graph.columns.shrink_to_fit();
  return result;
}

std::vector<int> idsOf(HostGraph const& graph, NodeMaps const& maps)
{
  std::vector<int> ids(graph.num_rows);
  for (int row = 0; row < graph.num_rows; ++row) {
    const auto id = maps.rows->getGlobalElement(row * graph.row_size) / graph.row_size;
    ids[row] = static_cast<int>(id & 0x7fffffff);
  }
  return ids;
}

HostBlocks blocksOf(HostGraph const& graph, NodeMaps const& maps, CrsMatrix const& matrix)
{
  auto const places = placesOfColumns(maps, matrix);
  auto const local = matrix.getLocalMatrixHost();
  const int rows = graph.row_size, columns = graph.column_size;
  const auto blocks = multigrid::makeNumbers<HostBlocks>(
    static_cast<std::size_t>(graph.numCouplings()) * graph.blockSize());
  for (int row = 0; row < graph.num_rows; ++row) {
    for (int r = 0; r < rows; ++r) {
      int coupling = graph.first[row];
      auto const& map = local.graph.row_map;
      for (auto k = map(row * rows + r); k < map(row * rows + r + 1); ++k) {
        const int place = places[local.graph.entries(k)];
        const int column = place / columns;
        if (graph.columns[coupling] != column) { // usually the next coupling is the right one
          coupling = coupling + 1 < graph.first[row + 1] && graph.columns[coupling + 1] == column
                       ? coupling + 1
                       : graph.find(row, column);
          ASPERITY_ASSERT(coupling >= 0);
        }
        blocks((static_cast<std::size_t>(coupling) * rows + r) * columns + place % columns) =
          static_cast<float>(local.values(k));
      }
    }
  }
  return blocks;
}

multigrid::SumOverRanks sumOver(RCP<const Communicator> const& communicator)
{
  return [communicator](double* values, int count) {
    const std::vector<double> mine(values, values + count);
    auto const all = sumOverRanks(mine, *communicator);
    std::copy(all.begin(), all.end(), values);
  };
}

multigrid::CoarsestRows coarsestRows(NodeMaps const& maps)
{
  auto const& rows = *maps.rows;
  auto const& communicator = rows.getComm();
  // Multigrid numbers its coarse rows 0 .. n - 1.
  const auto n = rows.getGlobalNumElements();
  if (n > static_cast<std::size_t>(multigrid::CoarsestRows::most)) {
    throw SolveError("Multigrid: the coarsest level has " + std::to_string(n) + " rows on " +
                     std::to_string(communicator->getSize()) + " ranks, and at most " +
                     std::to_string(multigrid::CoarsestRows::most) +
                     " can be factorised. Set TNNMG / Multigrid / Rows per Rank to its "
                     "default, or use fewer ranks.");
  }
  multigrid::CoarsestRows result;
  result.num_rows = static_cast<int>(n);
  for (std::size_t k = 0; k < numLocalElements(*maps.columns); ++k) {
    result.places.push_back(
      static_cast<int>(maps.columns->getGlobalElement(static_cast<LocalOrdinal>(k))));
  }
  result.sum = sumOver(communicator);
  const auto mine = numLocalElements(rows);
  if (maxOverRanks(mine > 0 && mine < n ? 1 : 0, *communicator) > 0) {
    result.sum_shared = [sum = result.sum](double* values, int count) {
      ASPERITY_NAME_WORK("V-cycles");
      sum(values, count);
    };
  }
  return result;
}
} // namespace asperity::tnnmg::detail
