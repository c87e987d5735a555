#include "tnnmg/levels/CoarsestSolver.hpp"

#include "base/Errors.hpp"
#include "base/parallel/Reductions.hpp"
#include "portability/Renamed.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Map.hpp>

#include <string>

namespace asperity::tnnmg::detail
{
// Sums over the ranks, if several of them have rows.
void CoarsestSolver::sumInPlace(double* values, Eigen::Index count) const
{
  if (is_shared_) {
    const std::vector<double> mine(values, values + count);
    Teuchos::reduceAll(*map_->getComm(), Teuchos::REDUCE_SUM, static_cast<int>(count), mine.data(),
                       values);
  }
}

CoarsestSolver::CoarsestSolver(NodeGraph const& graph, NodeBlocks const& A,
                               std::vector<char> const& free)
    : map_(graph.row_map)
    , free_(free)
{
  // Multigrid numbers its coarse rows 0 .. n - 1.
  const auto n = static_cast<Eigen::Index>(map_->getGlobalNumElements());
  if (n > most_rows) {
    throw SolveError("Multigrid: the coarsest level has " + std::to_string(n) + " rows on " +
                     std::to_string(map_->getComm()->getSize()) + " ranks, and at most " +
                     std::to_string(most_rows) +
                     " can be factorised. Set TNNMG / MueLu Correction / Rows per Rank to its "
                     "default, or use fewer ranks.");
  }
  const auto mine = static_cast<Eigen::Index>(numLocalElements(*map_));
  is_shared_ = maxOverRanks(mine > 0 && mine < n ? 1 : 0, *map_->getComm()) > 0;
  const bool has_factor = is_shared_ || mine == n;
  const int failed = has_factor && !factorise(graph, A, n) ? 1 : 0;
  if (maxOverRanks(failed, *map_->getComm()) > 0) {
    throw SolveError(
      "Multigrid: the coarsest matrix is not positive definite, so neither is the fine one. "
      "Check the sign of moduli, viscosities and densities.");
  }
}

bool CoarsestSolver::factorise(NodeGraph const& graph, NodeBlocks const& A, Eigen::Index n)
{
  const int size = graph.row_size;
  auto const& columns = graph.column_map.is_null() ? *graph.domain_map : *graph.column_map;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (int row = 0; row < graph.num_rows; ++row) {
    for (int k = graph.first[row]; k < graph.first[row + 1]; ++k) {
      for (int r = 0; r < size; ++r) {
        for (int c = 0; c < size; ++c) {
          matrix(map_->getGlobalElement(row * size + r),
                 columns.getGlobalElement(graph.columns[k] * size + c)) =
            A[(static_cast<std::size_t>(k) * size + r) * size + c];
        }
      }
    }
  }
  Eigen::VectorXd is_free = Eigen::VectorXd::Zero(n);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    is_free(map_->getGlobalElement(static_cast<LocalOrdinal>(i))) = free_[i];
  }
  sumInPlace(matrix.data(), matrix.size());
  sumInPlace(is_free.data(), n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (is_free(i) == 0) {
      matrix.row(i).setZero();
      matrix.col(i).setZero();
      matrix(i, i) = 1;
    }
  }
  matrix.diagonal() *= 1 + 1e-6;
  factor_.compute(matrix);
  return factor_.info() == Eigen::Success;
}

void CoarsestSolver::solve(NodeVector const& b, NodeVector& x) const
{
  if (factor_.rows() == 0) {
    return; // another rank has all rows
  }
  Eigen::VectorXd all = Eigen::VectorXd::Zero(factor_.rows());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    all(map_->getGlobalElement(static_cast<LocalOrdinal>(i))) = free_[i] ? b[i] : 0;
  }
  sumInPlace(all.data(), all.size());
  factor_.solveInPlace(all);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const double value = free_[i] ? all(map_->getGlobalElement(static_cast<LocalOrdinal>(i))) : 0;
    x[i] = static_cast<float>(value);
  }
}
} // namespace asperity::tnnmg::detail
