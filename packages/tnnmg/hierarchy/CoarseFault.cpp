#include "tnnmg/hierarchy/CoarseFault.hpp"

#include "portability/Renamed.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_RowMatrixTransposer.hpp>

#include <algorithm>

namespace asperity::tnnmg::detail
{
namespace
{
const auto to_be_computed = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();

// The nonlinear nodes of all ranks that act on this rank's columns of Q, as a map of their rows.
RCP<const Map> actingOnOwned(CrsMatrix const& Q, int tangents)
{
  const auto transpose =
    Tpetra::RowMatrixTransposer<double, LocalOrdinal, GlobalOrdinal>(Teuchos::rcpFromRef(Q))
      .createTranspose();
  auto const& columns = *transpose->getColMap();
  std::vector<GlobalOrdinal> nodes;
  for (std::size_t k = 0; k < numLocalElements(columns); ++k) {
    nodes.push_back(columns.getGlobalElement(static_cast<LocalOrdinal>(k)) / tangents);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<GlobalOrdinal> ids;
  for (auto node : nodes) {
    for (int t = 0; t < tangents; ++t) {
      ids.push_back(node * tangents + t);
    }
  }
  return rcp(new Map(to_be_computed, Teuchos::arrayViewFromVector(ids), 0, Q.getComm()));
}

// The nodes of Q's columns in the numbering of the level's matrix, -1 where it has no such column.
std::vector<int> inLevel(MappedGraph const& Q, NodeMaps const& level)
{
  auto const& from = *Q.maps.columns;
  auto const& to = *level.columns;
  const int size = Q.graph.column_size;
  std::vector<int> result(Q.graph.num_columns);
  for (std::size_t node = 0; node < result.size(); ++node) {
    const auto id = from.getGlobalElement(static_cast<LocalOrdinal>(node) * size);
    const auto local = to.getLocalElement(id);
    result[node] = local == Teuchos::OrdinalTraits<LocalOrdinal>::invalid() ? -1 : local / size;
  }
  return result;
}

// The Hessians of the nodes that act on this rank's rows, from those of this rank's nodes.
std::vector<double> importHessians(Import const& import, std::vector<double> const& hessian,
                                   int tangents)
{
  MultiVector owned(import.getSourceMap(), tangents);
  MultiVector all(import.getTargetMap(), tangents);
  {
    auto const values = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < hessian.size(); ++i) {
      values(i / tangents, i % tangents) = hessian[i];
    }
  }
  all.doImport(owned, import, Tpetra::INSERT);
  auto const values = all.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<double> result(values.extent(0) * tangents);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = values(i / tangents, i % tangents);
  }
  return result;
}
} // namespace

RCP<const CrsMatrix> rowsAtNodes(CrsMatrix const& P, NodeDofView const& fault)
{
  const auto dofs = toHost(fault);
  const int tangents = dofs.extent_int(1);
  const RCP<const Map> rows =
    rcp(new Map(to_be_computed, dofs.extent(0) * tangents, 0, P.getComm()));
  const auto local = P.getLocalMatrixHost();
  const auto Q = rcp(new CrsMatrix(rows, P.getColMap(), maxLocalRowEntries(P)));
  for (int node = 0; node < dofs.extent_int(0); ++node) {
    for (int t = 0; t < tangents; ++t) {
      const auto row = local.rowConst(dofs(node, t));
      if (row.length > 0) { // a matrix without entries has no place that these could point to
        Q->insertLocalValues(node * tangents + t, row.length, &row.value(0), &row.colidx(0));
      }
    }
  }
  Q->fillComplete(P.getDomainMap(), rows);
  return Q;
}

multigrid::HostAddedBlocks makeCoarseFault(RCP<const CrsMatrix> const& Q, int tangents,
                                           multigrid::HostGraph const& level, NodeMaps const& maps)
{
  multigrid::HostAddedBlocks fault;
  auto acting = Q;
  if (Q->getComm()->getSize() > 1) {
    const auto target = actingOnOwned(*Q, tangents);
    const RCP<const Import> import = rcp(new Import(Q->getRowMap(), target));
    acting =
      Tpetra::importAndFillCompleteCrsMatrix<CrsMatrix>(Q, *import, Q->getDomainMap(), target);
    fault.collect = [import, tangents](std::vector<double> const& hessian) {
      return importHessians(*import, hessian, tangents);
    };
  }
  const auto mapped = makeNodeGraph({acting}, tangents, level.column_size);
  fault.graph = mapped.graph;
  fault.Q = blocksOf(mapped.graph, mapped.maps, *acting);
  const auto in_level = inLevel(mapped, maps);
  std::vector<bool> touched(level.num_rows, false);
  fault.first = {0};
  for (int node = 0; node < fault.graph.num_rows; ++node) {
    const auto begin = fault.graph.columns.begin() + fault.graph.first[node];
    const auto end = fault.graph.columns.begin() + fault.graph.first[node + 1];
    for (auto row = begin; row != end; ++row) {
      const int J = in_level[*row];
      const bool owned = J >= 0 && J < level.num_rows;
      for (auto column = begin; column != end; ++column) {
        const int K = in_level[*column];
        fault.couplings.push_back(owned && K >= 0 ? level.find(J, K) : -1);
      }
      if (owned) {
        touched[J] = true;
      }
    }
    fault.first.push_back(static_cast<int>(fault.couplings.size()));
  }
  for (int row = 0; row < level.num_rows; ++row) {
    if (touched[row]) {
      fault.rows.push_back(row);
    }
  }
  return fault;
}
} // namespace asperity::tnnmg::detail
