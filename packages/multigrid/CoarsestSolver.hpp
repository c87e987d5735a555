#pragma once

#include "multigrid/Hierarchy.hpp"

#include <Eigen/Cholesky>

#include <memory>
#include <vector>

namespace asperity::multigrid
{
// A direct solve with the few hundred rows of the coarsest level, by the Cholesky factor of a dense
// matrix, on the host: on the rank that has all rows, or, where several have some, on all ranks.
class CoarsestSolver
{
public:
  // Components that are not free (free(owned dofs), 1 or 0) are left out. A millionth is added to
  // the diagonal, to allow for the rounding of A to single precision. Null on every rank if A is
  // not positive definite. Collective.
  static std::unique_ptr<CoarsestSolver> make(MatrixGraph const& graph, CoarsestRows rows,
                                              NodeBlocks const& A, std::vector<char> free);

  // x = A^-1 b for the owned dofs. Collective.
  void solve(NodeVector const& b, NodeVector const& x) const;

private:
  CoarsestSolver(CoarsestRows rows, std::vector<char> free);
  bool factorise(MatrixGraph const& graph, NodeBlocks const& A);
  void sumIfShared(double* values, Eigen::Index count) const;

  CoarsestRows rows_;
  std::vector<char> free_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};
} // namespace asperity::multigrid
