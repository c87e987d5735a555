#include "tnnmg/direct/SchurComplement.hpp"

#include "base/Errors.hpp"
#include "tnnmg/direct/EigenMatrix.hpp"
#include "tnnmg/direct/SupernodalFactor.hpp"

#include <Eigen/SparseCholesky>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <utility>

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

// S = L L^T. Eigen's product may differ in the last bit between the triangles.
ConstBlockView productWithTranspose(Eigen::MatrixXd const& L)
{
  const Eigen::MatrixXd S = L * L.transpose();
  const BlockView result("asperity::tnnmg::SchurComplement", S.rows(), S.cols());
  auto const host = Kokkos::create_mirror_view(result);
  for (int row = 0; row < S.rows(); ++row) {
    for (int column = 0; column < S.cols(); ++column) {
      host(row, column) = S(std::max(row, column), std::min(row, column));
    }
  }
  Kokkos::deep_copy(result, host);
  return result;
}
} // namespace

struct detail::EliminationFactor
{
  std::vector<int> position; // of every row of Z
  int num_eliminated = 0;
  std::size_t entries = 0;  // of L
  SupernodalFactor columns; // of L_I and L_FI
};

SchurComplement::SchurComplement(CrsMatrix const& Z, std::vector<int> const& rows)
    : SchurComplement(Z, rows, *std::make_unique<EliminationOrder>())
{
}

SchurComplement::SchurComplement(CrsMatrix const& Z, std::vector<int> const& rows,
                                 EliminationOrder& order)
{
  ASPERITY_ASSERT(Z.getRowMap()->getComm()->getSize() == 1);
  auto const matrix = detail::toEigen(Z, detail::StoredZeros::drop);
  auto const made = std::make_shared<detail::EliminationFactor>();
  auto& factor = *made;
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
  factor_ = made;

  Eigen::MatrixXd L_F = Eigen::MatrixXd::Zero(kept, kept);
  for (int column = 0; column < kept; ++column) {
    for (Sparse::InnerIterator entry(L, factor.num_eliminated + column); entry; ++entry) {
      L_F(entry.row() - factor.num_eliminated, column) = entry.value();
    }
  }
  matrix_ = productWithTranspose(L_F);
  map_ = rcp(new Map(kept, 0, Z.getRowMap()->getComm()));
}

CondensedRightSide::CondensedRightSide(std::shared_ptr<const detail::EliminationFactor> factor,
                                       Vector const& b, RCP<const Map> const& map)
    : factor_(std::move(factor))
    , half_solved_(factor_->position.size())
    , kept_(map)
{
  auto const values = b.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t row = 0; row < half_solved_.size(); ++row) {
    half_solved_[factor_->position[row]] = values(row, 0);
  }
  factor_->columns.forward(half_solved_.data());
  auto const kept = kept_.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy(half_solved_.begin() + factor_->num_eliminated, half_solved_.end(), kept.data());
}

void CondensedRightSide::expand(Vector const& v_kept, Vector& v) const
{
  auto x = half_solved_;
  auto const kept = v_kept.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::copy_n(kept.data(), kept.extent(0), x.begin() + factor_->num_eliminated);
  factor_->columns.backward(x.data());
  auto const values = v.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t row = 0; row < x.size(); ++row) {
    values(row, 0) = x[factor_->position[row]];
  }
}

std::size_t SchurComplement::factorEntries() const { return factor_->entries; }

std::size_t SchurComplement::bytes() const
{
  return factor_->columns.bytes() + sizeof(double) * matrix_.size();
}
} // namespace asperity::tnnmg
