#include "multigrid/CoarsestSolver.hpp"

#include <utility>

namespace asperity::multigrid
{
CoarsestSolver::CoarsestSolver(CoarsestRows rows, std::vector<char> free)
    : rows_(std::move(rows))
    , free_(std::move(free))
{
}

std::unique_ptr<CoarsestSolver> CoarsestSolver::make(MatrixGraph const& graph, CoarsestRows rows,
                                                     NodeBlocks const& A, std::vector<char> free)
{
  std::unique_ptr<CoarsestSolver> solver(new CoarsestSolver(std::move(rows), std::move(free)));
  const bool has_factor =
    solver->rows_.sum_shared || graph.rows() == static_cast<std::size_t>(solver->rows_.num_rows);
  double failed = has_factor && !solver->factorise(graph, A) ? 1 : 0;
  solver->rows_.sum(&failed, 1);
  return failed > 0 ? nullptr : std::move(solver);
}

void CoarsestSolver::sumIfShared(double* values, Eigen::Index count) const
{
  if (rows_.sum_shared) {
    rows_.sum_shared(values, static_cast<int>(count));
  }
}

bool CoarsestSolver::factorise(MatrixGraph const& graph, NodeBlocks const& A)
{
  const int size = graph.row_size;
  const auto blocks = toHost(A);
  auto const& place = rows_.places;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows_.num_rows, rows_.num_rows);
  graph.forEachCoupling([&](int row, int column, int k) {
    for (int r = 0; r < size; ++r) {
      for (int c = 0; c < size; ++c) {
        matrix(place[row * size + r], place[column * size + c]) =
          blocks((static_cast<std::size_t>(k) * size + r) * size + c);
      }
    }
  });
  Eigen::VectorXd is_free = Eigen::VectorXd::Zero(rows_.num_rows);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    is_free(place[i]) = free_[i];
  }
  sumIfShared(matrix.data(), matrix.size());
  sumIfShared(is_free.data(), is_free.size());
  for (Eigen::Index i = 0; i < is_free.size(); ++i) {
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

void CoarsestSolver::solve(NodeVector const& b, NodeVector const& x) const
{
  if (factor_.rows() == 0) {
    return; // another rank has all rows
  }
  const auto given = toHost(b);
  Eigen::VectorXd all = Eigen::VectorXd::Zero(factor_.rows());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    all(rows_.places[i]) = free_[i] ? given(i) : 0;
  }
  sumIfShared(all.data(), all.size());
  factor_.solveInPlace(all);
  const auto result = Kokkos::create_mirror_view(Kokkos::HostSpace(), x);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    result(i) = free_[i] ? static_cast<float>(all(rows_.places[i])) : 0;
  }
  Kokkos::deep_copy(x, result);
}
} // namespace asperity::multigrid
