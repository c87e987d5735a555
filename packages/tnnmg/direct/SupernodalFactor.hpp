#pragma once

#include <Eigen/SparseCore>

#include <vector>

namespace asperity::tnnmg::detail
{
// The first columns of a sparse Cholesky factor L, stored in supernodes: columns that follow each
// other and have nearly the same rows are one dense block, with a list of rows for all of them.
class SupernodalFactor
{
public:
  SupernodalFactor() = default;
  // L must be lower triangular with each column's rows ascending, the diagonal first, and the
  // pattern of a Cholesky factor: the rows of a column below its first one after the diagonal are
  // rows of that one, too.
  SupernodalFactor(Eigen::SparseMatrix<double> const& L, int num_columns);

  // x(all rows): solves with these columns and subtracts what they have in the other rows:
  // x_I <- L_I^-1 x_I, x_F <- x_F - L_FI x_I.
  void forward(double* x) const;
  // x_I <- L_I^-T (x_I - L_FI^T x_F).
  void backward(double* x) const;

  std::size_t bytes() const;

private:
  struct Supernode
  {
    int first_column, width;
    std::size_t first_row, num_rows; // in rows_, of those below the dense triangle
    std::size_t values;              // in values_: (width + num_rows, width) by columns
  };
  void add(Eigen::SparseMatrix<double> const& L, int first, int width);

  std::vector<Supernode> supernodes_;
  std::vector<int> rows_;
  std::vector<double> values_;
  mutable std::vector<double> work_;
};
} // namespace asperity::tnnmg::detail
