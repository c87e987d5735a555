#include "tnnmg/detail/CoarseCholesky.hpp"

#include "base/Errors.hpp"
#include "tnnmg/detail/EigenMatrix.hpp"

#include <Eigen/SparseCholesky>
#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

namespace asperity::tnnmg::detail
{
struct CoarseCholesky::Factor
{
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky;
};

namespace
{
// All global ids of a map in one ascending list on rank 0. Multigrid numbers its coarse rows 0 .. n
// - 1.
RCP<const Map> mapOnRankZero(Map const& map)
{
  ASPERITY_ASSERT(map.getMinAllGlobalIndex() == 0 &&
                  map.getMaxAllGlobalIndex() + 1 ==
                    static_cast<GlobalOrdinal>(map.getGlobalNumElements()));
  const auto num_global = map.getGlobalNumElements();
  const std::size_t num_local = map.getComm()->getRank() == 0 ? num_global : 0;
  return rcp(new Map(num_global, num_local, 0, map.getComm()));
}

// Gives rows without entries, or with zeros alone, a one on their diagonal.
void completeEmptyRows(Eigen::SparseMatrix<double>& matrix)
{
  const Eigen::VectorXd magnitude = matrix.cwiseAbs() * Eigen::VectorXd::Ones(matrix.cols());
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    if (magnitude(row) == 0) {
      matrix.coeffRef(row, row) = 1;
    }
  }
  matrix.makeCompressed();
}
} // namespace

CoarseCholesky::CoarseCholesky(CrsMatrix const& A) : factor_(std::make_unique<Factor>())
{
  const auto target = mapOnRankZero(*A.getRowMap());
  gather_ = rcp(new Import(A.getRowMap(), target));
  gathered_ = rcp(new MultiVector(target, 1));
  auto gathered = Tpetra::importAndFillCompleteCrsMatrix<CrsMatrix>(Teuchos::rcpFromRef(A),
                                                                    *gather_, target, target);
  factorise(*gathered);
}

CoarseCholesky::~CoarseCholesky() = default;

void CoarseCholesky::factorise(CrsMatrix const& gathered)
{
  auto& cholesky = factor_->cholesky;
  int definite = 1;
  if (gathered.getRowMap()->getComm()->getRank() == 0) {
    auto matrix = toEigen(gathered, StoredZeros::keep);
    completeEmptyRows(matrix);
    cholesky.compute(matrix);
    definite = cholesky.info() == Eigen::Success && (cholesky.vectorD().array() > 0).all();
  }
  Teuchos::broadcast(*gathered.getRowMap()->getComm(), 0, &definite);
  if (!definite) {
    throw SolveError(
      "Multigrid: the coarsest matrix is not positive definite, so neither is the fine one. "
      "Check the sign of moduli, viscosities and densities.");
  }
}

void CoarseCholesky::solve(MultiVector const& b, MultiVector& x) const
{
  if (gathered_->getNumVectors() != b.getNumVectors()) {
    throw std::invalid_argument("CoarseCholesky solves for one vector at a time");
  }
  gathered_->doImport(b, *gather_, Tpetra::INSERT);
  if (const auto n = static_cast<Eigen::Index>(gathered_->getLocalLength()); n > 0) {
    auto values = gathered_->getLocalViewHost(Tpetra::Access::ReadWrite);
    Eigen::Map<Eigen::VectorXd> vector(values.data(), n);
    vector = factor_->cholesky.solve(vector).eval();
  }
  x.doExport(*gathered_, *gather_, Tpetra::INSERT);
}
} // namespace asperity::tnnmg::detail
