#include "fem/Colouring.hpp"

#include "base/Hashes.hpp"
#include "base/parallel/Reductions.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_CrsGraph.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

namespace asperity::fem
{
namespace
{
using ColourVector = Tpetra::Vector<int, LocalOrdinal, GlobalOrdinal>;
using IdVector = Tpetra::Vector<GlobalOrdinal, LocalOrdinal, GlobalOrdinal>;
using HostDofs = Kokkos::View<const LocalOrdinal**, Kokkos::LayoutRight, Kokkos::HostSpace>;
using Weight = std::pair<std::uint64_t, GlobalOrdinal>; // hash, and the id for equal hashes

constexpr int uncoloured = -1;

Weight weightOf(GlobalOrdinal id) { return {splitMix(static_cast<std::uint64_t>(id)), id}; }

// Neighbours and weights of this rank's rows, by local columns.
struct Neighbourhood
{
  explicit Neighbourhood(CrsGraph const& graph) : offsets(1, 0)
  {
    const auto local = graph.getLocalGraphHost();
    const auto rows = graph.getRowMap()->getLocalMap();
    const auto columns = graph.getColMap()->getLocalMap();
    for (std::size_t column = 0; column < numLocalColumns(graph); ++column) {
      weights.push_back(weightOf(columns.getGlobalElement(static_cast<int>(column))));
    }
    for (std::size_t row = 0; row < numLocalRows(graph); ++row) {
      const GlobalOrdinal id = rows.getGlobalElement(static_cast<int>(row));
      own_weights.push_back(weightOf(id));
      const LocalOrdinal own_column =
        columns.getLocalElement(id); // invalid if there is no self loop
      for (auto k = local.row_map(row); k < local.row_map(row + 1); ++k) {
        if (local.entries(k) != own_column) {
          neighbours.push_back(local.entries(k));
        }
      }
      offsets.push_back(neighbours.size());
    }
  }

  // The smallest colour that no neighbour has, if all uncoloured neighbours are lighter; uncoloured
  // otherwise.
  template <class Colours>
  int choose(int row, Colours const& colours) const
  {
    std::vector<bool> taken(offsets[row + 1] - offsets[row] + 1, false);
    for (auto k = offsets[row]; k < offsets[row + 1]; ++k) {
      const int colour = colours(neighbours[k], 0);
      if (colour == uncoloured && weights[neighbours[k]] > own_weights[row]) {
        return uncoloured;
      }
      if (colour != uncoloured && static_cast<std::size_t>(colour) < taken.size()) {
        taken[colour] = true;
      }
    }
    return static_cast<int>(std::find(taken.begin(), taken.end(), false) - taken.begin());
  }

  std::vector<std::size_t> offsets;
  std::vector<LocalOrdinal> neighbours;     // local columns, without the row itself
  std::vector<Weight> weights, own_weights; // of columns, of rows
};

// One round of Jones and Plassmann: every node that is heavier than its uncoloured neighbours
// chooses a colour. A round sees the colours of the round before on all ranks. Returns how many
// nodes chose.
int colourHeaviest(CrsGraph const& graph, Neighbourhood const& neighbourhood,
                   ColourVector const& seen, ColourVector& colours)
{
  const auto before = seen.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto after = colours.getLocalViewHost(Tpetra::Access::ReadWrite);
  int num_chosen = 0;
  for (int row = 0; row < static_cast<int>(numLocalRows(graph)); ++row) {
    if (after(row, 0) == uncoloured) {
      after(row, 0) = neighbourhood.choose(row, before);
      num_chosen += after(row, 0) != uncoloured;
    }
  }
  return num_chosen;
}

Colouring gather(CrsGraph const& graph, ColourVector const& colours)
{
  const auto host = colours.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto num_rows = static_cast<LocalOrdinal>(numLocalRows(graph));
  int mine = 0;
  for (LocalOrdinal row = 0; row < num_rows; ++row) {
    mine = std::max(mine, host(row, 0) + 1);
  }
  Colouring result(maxOverRanks(mine, *graph.getComm()));
  for (LocalOrdinal row = 0; row < num_rows; ++row) {
    result[host(row, 0)].push_back(row);
  }
  return result;
}

// For each column of the graph the id of its node, that is, the global id of the node's first dof;
// -1 for a column of no node.
IdVector nodesOfColumns(CrsGraph const& graph, HostDofs const& dofs)
{
  IdVector of_dof(graph.getDomainMap());
  of_dof.putScalar(-1);
  {
    auto host = of_dof.getLocalViewHost(Tpetra::Access::ReadWrite);
    for (int node = 0; node < dofs.extent_int(0); ++node) {
      for (int t = 0; t < dofs.extent_int(1); ++t) {
        host(dofs(node, t), 0) = graph.getRowMap()->getGlobalElement(dofs(node, 0));
      }
    }
  }
  IdVector of_column(graph.getColMap());
  of_column.doImport(of_dof, Import(graph.getDomainMap(), graph.getColMap()), Tpetra::INSERT);
  return of_column;
}

std::set<GlobalOrdinal> neighboursOf(int node, CrsGraph const& graph, HostDofs const& dofs,
                                     IdVector const& of_column)
{
  const auto host = of_column.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto local = graph.getLocalGraphHost();
  std::set<GlobalOrdinal> neighbours;
  for (int t = 0; t < dofs.extent_int(1); ++t) {
    const int row = dofs(node, t);
    for (auto k = local.row_map(row); k < local.row_map(row + 1); ++k) {
      if (const GlobalOrdinal id = host(local.entries(k), 0); id >= 0) {
        neighbours.insert(id);
      }
    }
  }
  return neighbours;
}
} // namespace

Colouring colourNodes(CrsGraph const& graph)
{
  const Neighbourhood neighbourhood(graph);
  ColourVector colours(graph.getDomainMap());
  ColourVector seen(graph.getColMap());
  colours.putScalar(uncoloured);
  auto num_left = static_cast<GlobalOrdinal>(graph.getGlobalNumRows());
  while (num_left > 0) {
    if (graph.getImporter().is_null()) {
      Tpetra::deep_copy(seen, colours);
    } else {
      seen.doImport(colours, *graph.getImporter(), Tpetra::INSERT);
    }
    const int num_chosen = colourHeaviest(graph, neighbourhood, seen, colours);
    num_left -= sumOverRanks(GlobalOrdinal(num_chosen), *graph.getComm());
  }
  return gather(graph, colours);
}

namespace
{
// Nodes, numbered as in dofs, by what couples their rows.
Colouring colourNodesOf(CrsGraph const& graph_of_dofs, NodeDofView const& dofs)
{
  const HostDofs host = toHost(dofs);
  const auto of_column = nodesOfColumns(graph_of_dofs, host);
  std::vector<GlobalOrdinal> ids;
  std::vector<std::vector<GlobalOrdinal>> neighbours;
  std::size_t longest_row = 1;
  for (int node = 0; node < host.extent_int(0); ++node) {
    const auto found = neighboursOf(node, graph_of_dofs, host, of_column);
    ids.push_back(graph_of_dofs.getRowMap()->getGlobalElement(host(node, 0)));
    neighbours.emplace_back(found.begin(), found.end());
    longest_row = std::max(longest_row, found.size());
  }
  const auto num_global =
    Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(); // to be computed
  const RCP<const Map> map =
    rcp(new Map(num_global, Teuchos::arrayViewFromVector(ids), 0, graph_of_dofs.getComm()));
  CrsGraph graph(map, longest_row);
  for (std::size_t node = 0; node < ids.size(); ++node) {
    graph.insertGlobalIndices(ids[node], Teuchos::arrayViewFromVector(neighbours[node]));
  }
  graph.fillComplete();
  return colourNodes(graph);
}
} // namespace

std::vector<IndexView> colourFreeNodes(CrsGraph const& graph, NodeDofView const& dofs,
                                       std::vector<int> const& held)
{
  auto const host = toHost(dofs);
  std::vector<IndexView> colours;
  for (auto const& nodes : colourNodesOf(graph, dofs)) {
    std::vector<int> free;
    for (int node : nodes) {
      int num_held = 0;
      for (int k = 0; k < host.extent_int(1); ++k) {
        num_held += held[host(node, k)];
      }
      if (num_held < host.extent_int(1)) {
        free.push_back(node);
      }
    }
    colours.emplace_back(toDevice(free, "asperity::fem::colour"));
  }
  return colours;
}
} // namespace asperity::fem
