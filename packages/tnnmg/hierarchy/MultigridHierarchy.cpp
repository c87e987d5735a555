#include "tnnmg/hierarchy/MultigridHierarchy.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "tnnmg/hierarchy/CoarseFault.hpp"
#include "tnnmg/hierarchy/MultigridProlongators.hpp"

#include <TpetraExt_MatrixMatrix.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <utility>

namespace asperity::tnnmg::detail
{
namespace
{
RCP<const CrsMatrix> multiply(CrsMatrix const& A, CrsMatrix const& B, Map const& rows)
{
  const auto result = rcp(new CrsMatrix(Teuchos::rcpFromRef(rows), 0));
  Tpetra::MatrixMatrix::Multiply(A, false, B, false, *result);
  return result;
}

// P^T A P
RCP<const CrsMatrix> project(CrsMatrix const& A, CrsMatrix const& P)
{
  const auto AP = multiply(A, P, *A.getRowMap());
  const auto result = rcp(new CrsMatrix(P.getDomainMap(), 0));
  Tpetra::MatrixMatrix::Multiply(P, true, *AP, false, *result);
  return result;
}

// The coarse levels, and on each of them all terms. These have to be there together, since products
// leave out what is multiplied by a stored zero: one term may couple nodes that another does not.
struct Projections
{
  std::vector<ProjectedLevel> levels;
  std::vector<std::vector<RCP<const CrsMatrix>>> terms; // of each coarse level
};

Projections projections(RCP<const CrsMatrix> const& first, std::vector<MatrixSource> const& terms,
                        RCP<const MultiVector> const& near_null_space,
                        Aggregation const& aggregation)
{
  Projections result;
  result.levels =
    coarseLevels(first, near_null_space, aggregation.muelu, aggregation.rows_per_rank);
  for (auto const& level : result.levels) {
    result.terms.push_back({level.A});
  }
  for (std::size_t k = 1; k < terms.size(); ++k) {
    auto matrix = terms[k]();
    for (std::size_t l = 0; l < result.levels.size(); ++l) {
      matrix = project(*matrix, *result.levels[l].P);
      result.terms[l].push_back(matrix);
    }
  }
  return result;
}
} // namespace

Teuchos::ParameterList MultigridHierarchy::defaults(int components)
{
  Teuchos::ParameterList list("MueLu");
  list.set("verbosity", "none");
  list.set("number of equations", components);
  list.set("multigrid algorithm", "sa");
  list.set("max levels", 10);
  list.set("coarse: max size", 200);
  list.set("coarse: type", "none"); // the cycle has a solver and smoothers of its own
  list.set("smoother: pre or post", "none");
  list.set("reuse: type", "RP");             // keeps the prolongators
  list.set("transpose: use implicit", true); // makes no restrictions
  list.set("rap: fix zero diagonals",
           true); // where an aggregate loses a near null vector to constraints
  // The same prolongators on every backend. MueLu's factories for threads and devices, its default
  // there, throw on one rank alone where an aggregate loses a near null vector to constraints, and
  // refuse "aggregation: drop tol" where a node has several equations.
  list.set("use kokkos refactor", false);
  return list;
}

MultigridHierarchy::MultigridHierarchy(std::vector<MatrixSource> const& terms, int components,
                                       RCP<const MultiVector> const& near_null_space,
                                       NodeDofView const& fault, Aggregation const& aggregation)
{
  auto finest = terms.front()();
  auto const projected = projections(finest, terms, near_null_space, aggregation);
  auto const& coarse = projected.levels;
  const int motions = static_cast<int>(near_null_space->getNumVectors());
  const bool has_fault =
    sumOverRanks(fault.extent_int(0), *near_null_space->getMap()->getComm()) > 0;
  std::vector<multigrid::HostLevel> levels;
  multigrid::CoarsestRows coarsest;
  RCP<const CrsMatrix> Q;
  for (std::size_t l = 0; l <= coarse.size(); ++l) {
    multigrid::HostLevel level;
    const int size = l == 0 ? components : motions;
    auto const matrices =
      l == 0 ? std::vector<RCP<const CrsMatrix>>{finest} : projected.terms[l - 1];
    auto [graph, maps] = makeNodeGraph(matrices, size, size);
    for (std::size_t k = 0; l > 0 && k < matrices.size(); ++k) {
      level.terms.push_back(blocksOf(graph, maps, *matrices[k]));
    }
    if (l > 0 && has_fault) {
      Q =
        l == 1 ? rowsAtNodes(*coarse[0].P, fault) : multiply(*Q, *coarse[l - 1].P, *Q->getRowMap());
      level.added = makeCoarseFault(Q, fault.extent_int(1), graph, maps);
    }
    if (l < coarse.size()) {
      if (aggregation.keeps_prolongators) {
        prolongators_.push_back(coarse[l].P);
      }
      auto prolongation = makeNodeGraph({coarse[l].P}, size, motions);
      level.P = blocksOf(prolongation.graph, prolongation.maps, *coarse[l].P);
      level.prolongation = std::move(prolongation.graph);
    } else {
      coarsest = coarsestRows(maps);
    }
    if (l == 0) {
      finest_graph_ = graph;
      finest_maps_ = maps;
    }
    level.ids = idsOf(graph, maps);
    level.graph = std::move(graph);
    levels.push_back(std::move(level));
    finest = Teuchos::null;
  }
  hierarchy_ = std::make_shared<const multigrid::Hierarchy>(std::move(levels), std::move(coarsest),
                                                            aggregation.row_order);
}

multigrid::HostBlocks MultigridHierarchy::finestBlocks(CrsMatrix const& Z) const
{
  return blocksOf(finest_graph_, finest_maps_, Z);
}
} // namespace asperity::tnnmg::detail
