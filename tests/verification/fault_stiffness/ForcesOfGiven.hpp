#pragma once

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <vector>

namespace asperity::verification
{
// The forces K u where u is given in part; the rest of u is such that no force acts there. K must
// be symmetric; u has what is given, and zeros.
inline Eigen::VectorXd forcesOfGiven(Eigen::SparseMatrix<double> const& K,
                                     std::vector<bool> const& is_given, Eigen::VectorXd u)
{
  Eigen::VectorXd right_side = -K * u;
  // Its values change below, through iterators. NOLINTNEXTLINE(performance-unnecessary-copy*)
  auto A = K;
  for (int column = 0; column < A.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(A, column); entry; ++entry) {
      if (is_given[entry.row()] || is_given[entry.col()]) {
        entry.valueRef() = entry.row() == entry.col() ? 1 : 0;
      }
    }
  }
  for (int dof = 0; dof < K.rows(); ++dof) {
    right_side[dof] = is_given[dof] ? 0 : right_side[dof];
  }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
  EXPECT_EQ(solver.info(), Eigen::Success);
  u += solver.solve(right_side);
  return K * u;
}
} // namespace asperity::verification
