#include "tnnmg/NonlinearNodes.hpp"

#include <Tpetra_CrsGraph.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <set>
#include <string>

namespace asperity::tnnmg
{
namespace
{
template <class T>
Kokkos::View<const T*, MemorySpace> toDevice(std::vector<T> const& values, char const* label)
{
  Kokkos::View<T*, MemorySpace> view(std::string(label), values.size());
  auto const host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < values.size(); ++i) {
    host(i) = values[i];
  }
  Kokkos::deep_copy(view, host);
  return view;
}

NonlinearDofView toDevice(std::vector<std::vector<int>> const& dofs, int block_size)
{
  Kokkos::View<LocalOrdinal**, Kokkos::LayoutRight, MemorySpace> view("asperity::tnnmg::dofs",
                                                                      dofs.size(), block_size);
  auto const host = Kokkos::create_mirror_view(view);
  for (std::size_t node = 0; node < dofs.size(); ++node) {
    for (int k = 0; k < block_size; ++k) {
      host(node, k) = dofs[node][k];
    }
  }
  Kokkos::deep_copy(view, host);
  return view;
}

// Which nonlinear nodes are coupled by Z, in a numbering of their own.
RCP<const CrsGraph> graphOfNodes(CrsMatrix const& Z, std::vector<std::vector<int>> const& dofs)
{
  auto const communicator = Z.getRowMap()->getComm();
  auto const unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  auto const map = rcp(new Map(unknown, dofs.size(), 0, communicator));

  // The number of its node at every nonlinear row, on Z's column map: -1 elsewhere.
  Vector on_rows(Z.getDomainMap());
  Vector on_columns(Z.getColMap());
  on_rows.putScalar(-1);
  {
    auto values = on_rows.getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t node = 0; node < dofs.size(); ++node) {
      for (int dof : dofs[node]) {
        values(dof, 0) = static_cast<double>(map->getGlobalElement(node));
      }
    }
  }
  if (Z.getGraph()->getImporter().is_null()) {
    Tpetra::deep_copy(on_columns, on_rows);
  } else {
    on_columns.doImport(on_rows, *Z.getGraph()->getImporter(), Tpetra::INSERT);
  }

  auto const numbers = on_columns.getLocalViewHost(Tpetra::Access::ReadOnly);
  auto const local = Z.getLocalMatrixHost();
  std::vector<std::set<GlobalOrdinal>> rows(dofs.size());
  std::size_t longest = 0;
  for (std::size_t node = 0; node < dofs.size(); ++node) {
    for (int dof : dofs[node]) {
      for (auto k = local.graph.row_map(dof); k < local.graph.row_map(dof + 1); ++k) {
        const double number = numbers(local.graph.entries(k), 0);
        if (number >= 0) {
          rows[node].insert(static_cast<GlobalOrdinal>(number));
        }
      }
    }
    longest = std::max(longest, rows[node].size());
  }
  auto graph = rcp(new CrsGraph(map, longest));
  for (std::size_t node = 0; node < rows.size(); ++node) {
    const std::vector<GlobalOrdinal> columns(rows[node].begin(), rows[node].end());
    graph->insertGlobalIndices(map->getGlobalElement(node), Teuchos::arrayViewFromVector(columns));
  }
  graph->fillComplete();
  return graph;
}
} // namespace

NonlinearNodes nonlinearNodes(CrsMatrix const& Z, std::vector<std::vector<int>> const& dofs,
                              int block_size, std::vector<int> const& fixed)
{
  auto const colouring = colourNodes(*graphOfNodes(Z, dofs));
  NonlinearNodes nodes;
  nodes.dofs = toDevice(dofs, block_size);
  nodes.fixed = toDevice(fixed, "asperity::tnnmg::fixed");
  for (auto const& rows : colouring.rows) {
    std::vector<int> free;
    for (int row : rows) {
      if (!fixed[row]) {
        free.push_back(row);
      }
    }
    nodes.colours.push_back(toDevice(free, "asperity::tnnmg::colour"));
  }
  return nodes;
}

NonlinearNodes coupledNodes(int num_nodes, int block_size, std::vector<int> const& fixed)
{
  std::vector<std::vector<int>> dofs(num_nodes);
  for (int node = 0; node < num_nodes; ++node) {
    for (int k = 0; k < block_size; ++k) {
      dofs[node].push_back(node * block_size + k);
    }
  }
  NonlinearNodes nodes;
  nodes.dofs = toDevice(dofs, block_size);
  nodes.fixed = toDevice(fixed, "asperity::tnnmg::fixed");
  for (int node = 0; node < num_nodes; ++node) {
    if (!fixed[node]) {
      nodes.colours.push_back(toDevice(std::vector<int>{node}, "asperity::tnnmg::colour"));
    }
  }
  return nodes;
}
} // namespace asperity::tnnmg
