#include "tnnmg/levels/NodeMatrix.hpp"

#include "base/Errors.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/levels/NodeKernels.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>

#include <algorithm>

namespace asperity::tnnmg::detail
{
namespace
{
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
std::vector<int> placesOfColumns(NodeGraph const& graph, CrsMatrix const& matrix)
{
  auto const& from = *matrix.getColMap();
  auto const& to = graph.column_map.is_null() ? *graph.domain_map : *graph.column_map;
  std::vector<int> places(numLocalElements(from));
  for (std::size_t k = 0; k < places.size(); ++k) {
    places[k] = to.getLocalElement(from.getGlobalElement(static_cast<LocalOrdinal>(k)));
  }
  return places;
}
} // namespace

int NodeGraph::find(int row, int column) const
{
  auto const begin = columns.begin() + first[row], end = columns.begin() + first[row + 1];
  auto const place = std::lower_bound(begin, end, column);
  return place != end && *place == column ? static_cast<int>(place - columns.begin()) : -1;
}

NodeGraph makeNodeGraph(std::vector<RCP<const CrsMatrix>> const& matrices, int row_size,
                        int column_size)
{
  NodeGraph graph;
  graph.row_size = row_size;
  graph.column_size = column_size;
  graph.row_map = matrices.front()->getRowMap();
  graph.domain_map = matrices.front()->getDomainMap();
  graph.num_rows = static_cast<int>(numLocalElements(*graph.row_map)) / row_size;
  graph.num_owned = static_cast<int>(numLocalElements(*graph.domain_map)) / column_size;
  if (graph.row_map->getComm()->getSize() > 1) {
    graph.column_map = columnMap(matrices, *graph.domain_map, column_size);
    std::vector<GlobalOrdinal> ghosts;
    for (auto k = static_cast<LocalOrdinal>(numLocalElements(*graph.domain_map));
         k < static_cast<LocalOrdinal>(numLocalElements(*graph.column_map)); ++k) {
      ghosts.push_back(graph.column_map->getGlobalElement(k));
    }
    graph.halo = std::make_shared<const Halo>(*graph.domain_map, ghosts);
  }
  std::vector<std::vector<int>> places;
  places.reserve(matrices.size());
  for (auto const& matrix : matrices) {
    places.push_back(placesOfColumns(graph, *matrix));
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
  return graph;
}

NodeBlocks blocksOf(NodeGraph const& graph, CrsMatrix const& matrix)
{
  auto const places = placesOfColumns(graph, matrix);
  auto const local = matrix.getLocalMatrixHost();
  const int rows = graph.row_size, columns = graph.column_size;
  NodeBlocks blocks(static_cast<std::size_t>(graph.numCouplings()) * graph.blockSize(), 0.f);
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
        blocks[(static_cast<std::size_t>(coupling) * rows + r) * columns + place % columns] =
          static_cast<float>(local.values(k));
      }
    }
  }
  return blocks;
}

GhostExchange::GhostExchange(NodeGraph const& graph)
    : halo_(graph.halo)
    , num_owned_(graph.num_owned * graph.column_size)
{
  if (halo_) {
    sent_.resize(halo_->sent().size());
    received_.resize(halo_->received().size());
  }
}

void GhostExchange::share(NodeVector& x) const
{
  if (!halo_) {
    return;
  }
  for (std::size_t i = 0; i < sent_.size(); ++i) {
    sent_[i] = x[halo_->sent()[i]];
  }
  halo_->share(sent_.data(), received_.data());
  for (std::size_t i = 0; i < received_.size(); ++i) {
    x[num_owned_ + halo_->received()[i]] = received_[i];
  }
}

void GhostExchange::gather(NodeVector& x) const
{
  if (!halo_) {
    return;
  }
  for (std::size_t i = 0; i < received_.size(); ++i) {
    received_[i] = x[num_owned_ + halo_->received()[i]];
  }
  halo_->gather(received_.data(), sent_.data());
  for (std::size_t i = 0; i < sent_.size(); ++i) {
    x[halo_->sent()[i]] += sent_[i];
  }
}

void multiplyAdd(NodeGraph const& graph, NodeBlocks const& A, NodeVector const& x, NodeVector& y)
{
  withBlockSizes(graph.row_size, graph.column_size, [&](auto rows, auto columns) {
    constexpr int R = decltype(rows)::value, C = decltype(columns)::value;
    for (int row = 0; row < graph.num_rows; ++row) {
      RowSums<R, C> sum;
      for (int k = graph.first[row]; k < graph.first[row + 1]; ++k) {
        sum.add(&A[static_cast<std::size_t>(k) * R * C], &x[graph.columns[k] * C]);
      }
      for (int r = 0; r < R; ++r) {
        y[row * R + r] += sum[r];
      }
    }
  });
}

void multiplyTransposed(NodeGraph const& graph, NodeBlocks const& A, NodeVector const& x,
                        NodeVector& y)
{
  std::fill(y.begin(), y.end(), 0.f);
  withBlockSizes(graph.row_size, graph.column_size, [&](auto rows, auto columns) {
    constexpr int R = decltype(rows)::value, C = decltype(columns)::value;
    for (int row = 0; row < graph.num_rows; ++row) {
      for (int k = graph.first[row]; k < graph.first[row + 1]; ++k) {
        addTransposed<R, C>(&A[static_cast<std::size_t>(k) * R * C], &x[row * R],
                            &y[graph.columns[k] * C]);
      }
    }
  });
}
} // namespace asperity::tnnmg::detail
