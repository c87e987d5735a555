#include "tnnmg/detail/CoarseCholesky.hpp"

#include "base/Errors.hpp"

#include <Eigen/SparseCholesky>
#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <vector>

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

Eigen::SparseMatrix<double> toEigen(CrsMatrix const& A)
{
  const auto local = A.getLocalMatrixHost();
  const auto columns = A.getColMap()->getLocalMap();
  const int num_rows = local.numRows();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(local.nnz() + num_rows);
  for (int row = 0; row < num_rows; ++row) {
    bool empty = true;
    for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
      const int column = static_cast<int>(columns.getGlobalElement(local.graph.entries(k)));
      entries.emplace_back(row, column, local.values(k));
      empty = empty && local.values(k) == 0;
    }
    if (empty) {
      entries.emplace_back(row, row, 1.0);
    }
  }
  Eigen::SparseMatrix<double> matrix(num_rows, num_rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
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
    cholesky.compute(toEigen(gathered));
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
