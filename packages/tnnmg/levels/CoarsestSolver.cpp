#include "tnnmg/levels/CoarsestSolver.hpp"

#include "base/Errors.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Map.hpp>

#include <string>

namespace asperity::tnnmg::detail
{
namespace
{
void sumInPlace(Communicator const& communicator, double* values, int count)
{
  if (communicator.getSize() > 1) {
    const std::vector<double> mine(values, values + count);
    Teuchos::reduceAll(communicator, Teuchos::REDUCE_SUM, count, mine.data(), values);
  }
}
} // namespace

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
                     " can be factorised on every rank. Use fewer ranks.");
  }
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
  sumInPlace(*map_->getComm(), matrix.data(), static_cast<int>(matrix.size()));
  sumInPlace(*map_->getComm(), is_free.data(), static_cast<int>(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    if (is_free(i) == 0) {
      matrix.row(i).setZero();
      matrix.col(i).setZero();
      matrix(i, i) = 1;
    }
  }
  matrix.diagonal() *= 1 + 1e-6;
  factor_.compute(matrix);
  if (factor_.info() != Eigen::Success) { // the same on all ranks
    throw SolveError(
      "Multigrid: the coarsest matrix is not positive definite, so neither is the fine one. "
      "Check the sign of moduli, viscosities and densities.");
  }
}

void CoarsestSolver::solve(NodeVector const& b, NodeVector& x) const
{
  Eigen::VectorXd all = Eigen::VectorXd::Zero(factor_.rows());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    all(map_->getGlobalElement(static_cast<LocalOrdinal>(i))) = free_[i] ? b[i] : 0;
  }
  sumInPlace(*map_->getComm(), all.data(), static_cast<int>(all.size()));
  factor_.solveInPlace(all);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const double value = free_[i] ? all(map_->getGlobalElement(static_cast<LocalOrdinal>(i))) : 0;
    x[i] = static_cast<float>(value);
  }
}
} // namespace asperity::tnnmg::detail
