#pragma once

#include "tnnmg/levels/NodeMatrix.hpp"

#include <Eigen/Cholesky>

namespace asperity::tnnmg::detail
{
// A direct solve with the few hundred rows of the coarsest level, by the Cholesky factor of a dense
// matrix: on the rank that has all rows, or, where several have some, on all ranks. Amesos2's KLU2,
// MueLu's default, gives wrong answers on two and more ranks.
class CoarsestSolver
{
public:
  // More rows make a matrix of gigabytes: aggregates do not cross ranks, so that on many ranks even
  // the coarsest level is large unless levels move to fewer ranks.
  static constexpr int most_rows = 20000;

  // Throws SolveError on every rank if A is not positive definite or has more than most_rows
  // rows. Components that are not free (free is (owned dofs), 1 or 0) are left out. A millionth is
  // added to the diagonal, to allow for the rounding of A to single precision. Collective.
  CoarsestSolver(NodeGraph const& graph, NodeBlocks const& A, std::vector<char> const& free);

  // x = A^-1 b for the owned dofs. Collective.
  void solve(NodeVector const& b, NodeVector& x) const;

private:
  // False if A is not positive definite.
  bool factorise(NodeGraph const& graph, NodeBlocks const& A, Eigen::Index num_rows);
  void sumInPlace(double* values, Eigen::Index count) const;

  RCP<const Map> map_;
  std::vector<char> free_;
  bool is_shared_ = false; // several ranks have rows
  Eigen::LLT<Eigen::MatrixXd> factor_;
};
} // namespace asperity::tnnmg::detail
