#include "tnnmg/levels/CoarseFault.hpp"

#include "base/Errors.hpp"
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
std::vector<int> inLevel(NodeGraph const& graph, NodeGraph const& of_level)
{
  if (graph.column_map.is_null()) {
    std::vector<int> same(graph.num_owned);
    for (int node = 0; node < graph.num_owned; ++node) {
      same[node] = node;
    }
    return same;
  }
  auto const& from = *graph.column_map;
  auto const& to = *of_level.column_map;
  std::vector<int> result(numLocalElements(from) / graph.column_size);
  for (std::size_t node = 0; node < result.size(); ++node) {
    const auto id = from.getGlobalElement(static_cast<LocalOrdinal>(node) * graph.column_size);
    const auto local = to.getLocalElement(id);
    result[node] =
      local == Teuchos::OrdinalTraits<LocalOrdinal>::invalid() ? -1 : local / graph.column_size;
  }
  return result;
}
} // namespace

RCP<const CrsMatrix> rowsAtNodes(CrsMatrix const& P, NodeDofView const& fault)
{
  const auto dofs = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fault);
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

CoarseFault makeCoarseFault(RCP<const CrsMatrix> const& Q, int tangents, NodeGraph const& of_level)
{
  CoarseFault fault;
  auto acting = Q;
  if (Q->getComm()->getSize() > 1) {
    const auto target = actingOnOwned(*Q, tangents);
    fault.nodes = rcp(new Import(Q->getRowMap(), target));
    acting =
      Tpetra::importAndFillCompleteCrsMatrix<CrsMatrix>(Q, *fault.nodes, Q->getDomainMap(), target);
  }
  fault.graph = makeNodeGraph({acting}, tangents, of_level.column_size);
  fault.Q = blocksOf(fault.graph, *acting);
  const auto in_level = inLevel(fault.graph, of_level);
  std::vector<bool> touched(of_level.num_rows, false);
  fault.first = {0};
  for (int node = 0; node < fault.graph.num_rows; ++node) {
    const auto begin = fault.graph.columns.begin() + fault.graph.first[node];
    const auto end = fault.graph.columns.begin() + fault.graph.first[node + 1];
    for (auto row = begin; row != end; ++row) {
      const int J = in_level[*row];
      const bool owned = J >= 0 && J < of_level.num_rows;
      for (auto column = begin; column != end; ++column) {
        const int K = in_level[*column];
        fault.couplings.push_back(owned && K >= 0 ? of_level.find(J, K) : -1);
      }
      if (owned) {
        touched[J] = true;
      }
    }
    fault.first.push_back(static_cast<int>(fault.couplings.size()));
  }
  for (int row = 0; row < of_level.num_rows; ++row) {
    if (touched[row]) {
      fault.rows.push_back(row);
    }
  }
  return fault;
}

namespace
{
// The Hessians of the nodes that act on this rank's rows.
std::vector<double> acting(CoarseFault const& fault, std::vector<double> const& hessian)
{
  if (fault.nodes.is_null()) {
    return hessian;
  }
  const int tangents = fault.graph.row_size;
  MultiVector owned(fault.nodes->getSourceMap(), tangents);
  MultiVector all(fault.nodes->getTargetMap(), tangents);
  {
    auto const values = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < hessian.size(); ++i) {
      values(i / tangents, i % tangents) = hessian[i];
    }
  }
  all.doImport(owned, *fault.nodes, Tpetra::INSERT);
  auto const values = all.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<double> result(values.extent(0) * tangents);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = values(i / tangents, i % tangents);
  }
  return result;
}

// Adds Q_J^T H Q_K and, if J is not K, its transpose: one product for both keeps the sum symmetric.
template <int T, int N>
void addNode(CoarseFault const& fault, int node, double const* H, NodeBlocks& A)
{
  const int begin = fault.graph.first[node];
  const int count = fault.graph.first[node + 1] - begin;
  for (int j = 0; j < count; ++j) {
    float const* QJ = &fault.Q[static_cast<std::size_t>(begin + j) * T * N];
    double HQ[T][N]; // H Q_J
    for (int s = 0; s < T; ++s) {
      for (int c = 0; c < N; ++c) {
        HQ[s][c] = 0;
        for (int t = 0; t < T; ++t) {
          HQ[s][c] += H[s * T + t] * QJ[t * N + c];
        }
      }
    }
    for (int k = j; k < count; ++k) {
      const int to = fault.couplings[fault.first[node] + j * count + k];
      const int back = k > j ? fault.couplings[fault.first[node] + k * count + j] : -1;
      if (to < 0 && back < 0) {
        continue;
      }
      float const* QK = &fault.Q[static_cast<std::size_t>(begin + k) * T * N];
      for (int r = 0; r < N; ++r) {
        for (int c = 0; c < N; ++c) {
          double sum = 0;
          for (int s = 0; s < T; ++s) {
            sum += HQ[s][r] * QK[s * N + c];
          }
          if (to >= 0) {
            A[(static_cast<std::size_t>(to) * N + r) * N + c] += static_cast<float>(sum);
          }
          if (back >= 0) {
            A[(static_cast<std::size_t>(back) * N + c) * N + r] += static_cast<float>(sum);
          }
        }
      }
    }
  }
}

template <int T, int N>
void addAll(CoarseFault const& fault, std::vector<double> const& hessian, NodeBlocks& A)
{
  for (int node = 0; node < fault.graph.num_rows; ++node) {
    double const* H = &hessian[static_cast<std::size_t>(node) * T * T];
    if (std::any_of(H, H + T * T, [](double entry) { return entry != 0; })) {
      addNode<T, N>(fault, node, H, A);
    }
  }
}

template <int T>
void addWithTangents(CoarseFault const& fault, std::vector<double> const& hessian, NodeBlocks& A)
{
  switch (fault.graph.column_size) { // rigid body motions, as in withBlockSizes
  case 1: return addAll<T, 1>(fault, hessian, A);
  case 2: return addAll<T, 2>(fault, hessian, A);
  case 3: return addAll<T, 3>(fault, hessian, A);
  case 4: return addAll<T, 4>(fault, hessian, A);
  case 6: return addAll<T, 6>(fault, hessian, A);
  default: ASPERITY_ASSERT(!"a number of motions that multigrid knows");
  }
}
} // namespace

void addHessians(CoarseFault const& fault, std::vector<double> const& hessian, NodeBlocks& A)
{
  const auto all = acting(fault, hessian);
  switch (fault.graph.row_size) {
  case 1: return addWithTangents<1>(fault, all, A);
  case 2: return addWithTangents<2>(fault, all, A);
  default: return addWithTangents<3>(fault, all, A);
  }
}
} // namespace asperity::tnnmg::detail
