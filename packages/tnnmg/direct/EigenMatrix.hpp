#pragma once

#include "base/Types.hpp"

#include <Eigen/SparseCore>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>

#include <vector>

namespace asperity::tnnmg::detail
{
enum class StoredZeros
{
  keep,
  drop
};

// Copies a square matrix, whose rows must all live on this rank, to an Eigen matrix with the same
// local rows. Runs on the host.
inline Eigen::SparseMatrix<double> toEigen(CrsMatrix const& A, StoredZeros zeros)
{
  const auto local = A.getLocalMatrixHost();
  const auto rows = A.getRowMap()->getLocalMap();
  const auto columns = A.getColMap()->getLocalMap();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(local.nnz());
  for (int row = 0; row < local.numRows(); ++row) {
    for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
      if (zeros == StoredZeros::keep || local.values(k) != 0) {
        const int column = rows.getLocalElement(columns.getGlobalElement(local.graph.entries(k)));
        entries.emplace_back(row, column, local.values(k));
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(local.numRows(), local.numRows());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}
} // namespace asperity::tnnmg::detail
