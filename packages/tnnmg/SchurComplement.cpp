#include "tnnmg/SchurComplement.hpp"

#include "base/Errors.hpp"
#include "portability/Renamed.hpp"
#include "tnnmg/detail/EigenMatrix.hpp"
#include "tnnmg/detail/SupernodalFactor.hpp"

#include <Eigen/SparseCholesky>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>

namespace asperity::tnnmg
{
namespace
{
using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

EliminationOrder::Pattern patternOf(Sparse const& Z) // which is compressed
{
  const int* starts = Z.outerIndexPtr();
  const int* rows = Z.innerIndexPtr();
  return {{starts, starts + Z.cols() + 1}, {rows, rows + Z.nonZeros()}};
}

Sparse permuted(Sparse const& Z, std::vector<int> const& position)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation(Z.rows());
  for (int row = 0; row < Z.rows(); ++row) {
    permutation.indices()(row) = position[row];
  }
  Sparse result(Z.rows(), Z.cols());
  result.selfadjointView<Eigen::Lower>() = Z.selfadjointView<Eigen::Lower>().twistedBy(permutation);
  return result;
}

RCP<const CrsMatrix> fullMatrix(Eigen::MatrixXd const& S,
                                RCP<const Communicator> const& communicator)
{
  const int size = static_cast<int>(S.rows());
  auto const map = rcp(new Map(size, 0, communicator));
  auto matrix = rcp(new CrsMatrix(map, map, size));
  std::vector<int> columns(size);
  std::vector<double> values(size);
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      columns[column] = column;
      values[column] = S(row, column);
    }
    matrix->insertLocalValues(row, size, values.data(), columns.data());
  }
  matrix->fillComplete(map, map);
  return matrix;
}
} // namespace

struct SchurComplement::Factor
{
  std::vector<int> position; // of every row of Z
  int num_eliminated = 0;
  std::size_t entries = 0;          // of L
  detail::SupernodalFactor columns; // of L_I and L_FI
  std::vector<double> half_solved;  // L_I^-1 b_I in its first num_eliminated entries
  mutable std::vector<double> work;
};

SchurComplement::SchurComplement(CrsMatrix const& Z, std::vector<int> const& rows)
    : SchurComplement(Z, rows, *std::make_unique<EliminationOrder>())
{
}

SchurComplement::SchurComplement(CrsMatrix const& Z, std::vector<int> const& rows,
                                 EliminationOrder& order)
    : factor_(std::make_unique<Factor>())
{
  ASPERITY_ASSERT(Z.getRowMap()->getComm()->getSize() == 1);
  auto const matrix = detail::toEigen(Z, detail::StoredZeros::drop);
  auto& factor = *factor_;
  factor.position = order.positions(patternOf(matrix), rows);
  const int size = static_cast<int>(matrix.rows());
  const int kept = static_cast<int>(rows.size());
  factor.num_eliminated = size - kept;
  const Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> cholesky(
    permuted(matrix, factor.position));
  if (cholesky.info() != Eigen::Success) {
    throw SolveError(
      "The matrix of a rate problem is not positive definite: some part of the body can move "
      "without resistance. Check the moduli and the boundary conditions.");
  }
  const Sparse L = cholesky.matrixL();
  factor.entries = L.nonZeros();
  factor.columns = detail::SupernodalFactor(L, factor.num_eliminated);
  factor.half_solved.resize(size);
  factor.work.resize(size);

  Eigen::MatrixXd L_F = Eigen::MatrixXd::Zero(kept, kept);
  for (int column = 0; column < kept; ++column) {
    for (Sparse::InnerIterator entry(L, factor.num_eliminated + column); entry; ++entry) {
      L_F(entry.row() - factor.num_eliminated, column) = entry.value();
    }
  }
  matrix_ = fullMatrix(L_F * L_F.transpose(), Z.getRowMap()->getComm());
}

SchurComplement::~SchurComplement() = default;

void SchurComplement::condense(Vector const& b, Vector& b_kept)
{
  auto& factor = *factor_;
  auto& x = factor.half_solved;
  auto const values = b.getLocalViewHost(Tpetra::Access::ReadOnly);
  const int size = static_cast<int>(x.size());
  for (int row = 0; row < size; ++row) {
    x[factor.position[row]] = values(row, 0);
  }
  factor.columns.forward(x.data());
  auto const kept = b_kept.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (int i = factor.num_eliminated; i < size; ++i) {
    kept(i - factor.num_eliminated, 0) = x[i];
  }
}

void SchurComplement::expand(Vector const& v_kept, Vector& v) const
{
  auto const& factor = *factor_;
  auto& x = factor.work;
  auto const kept = v_kept.getLocalViewHost(Tpetra::Access::ReadOnly);
  const int size = static_cast<int>(x.size());
  for (int i = factor.num_eliminated; i < size; ++i) {
    x[i] = kept(i - factor.num_eliminated, 0);
  }
  std::copy(factor.half_solved.begin(), factor.half_solved.begin() + factor.num_eliminated,
            x.begin());
  factor.columns.backward(x.data());
  auto const values = v.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (int row = 0; row < size; ++row) {
    values(row, 0) = x[factor.position[row]];
  }
}

std::size_t SchurComplement::factorEntries() const { return factor_->entries; }

std::size_t SchurComplement::bytes() const
{
  return factor_->columns.bytes() + numLocalEntries(*matrix_) * 16;
}
} // namespace asperity::tnnmg
