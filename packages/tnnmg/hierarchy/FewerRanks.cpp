#include "tnnmg/hierarchy/FewerRanks.hpp"

#include "base/Errors.hpp"
#include "portability/Renamed.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

namespace asperity::tnnmg::detail
{
namespace
{
// How many rows each rank has, eight bytes per rank, which a Tpetra::Map also stores.
std::vector<GlobalOrdinal> rowsOfRanks(Map const& rows)
{
  auto const& communicator = *rows.getComm();
  const auto mine = static_cast<GlobalOrdinal>(numLocalElements(rows));
  std::vector<GlobalOrdinal> counts(communicator.getSize());
  Teuchos::gatherAll<int, GlobalOrdinal>(communicator, 1, &mine, communicator.getSize(),
                                         counts.data());
  return counts;
}
} // namespace

RCP<const Map> onFewerRanks(Map const& rows, int rows_per_rank)
{
  auto const counts = rowsOfRanks(rows);
  const auto all = std::accumulate(counts.begin(), counts.end(), GlobalOrdinal(0));
  const GlobalOrdinal active =
    std::count_if(counts.begin(), counts.end(), [](auto count) { return count > 0; });
  if (active <= 1 || all >= rows_per_rank * active) {
    return Teuchos::null;
  }
  const auto groups = std::max<GlobalOrdinal>(1, all / rows_per_rank);
  const int self = rows.getComm()->getRank();
  GlobalOrdinal before = 0, last_group = -1, mine = 0;
  int owner = -1;
  for (int rank = 0; rank < static_cast<int>(counts.size()); ++rank) {
    if (counts[rank] == 0) {
      continue;
    }
    // A rank belongs to the group in which the middle of its rows lies.
    const auto group = (2 * before + counts[rank]) * groups / (2 * all);
    if (group != last_group) {
      owner = rank;
      last_group = group;
    }
    mine += owner == self ? counts[rank] : 0;
    ASPERITY_ASSERT(rank != self ||
                    (rows.getMinGlobalIndex() == rows.getIndexBase() + before &&
                     rows.getMaxGlobalIndex() == rows.getMinGlobalIndex() + counts[rank] - 1));
    before += counts[rank];
  }
  return rcp(new Map(all, static_cast<std::size_t>(mine), rows.getIndexBase(), rows.getComm()));
}

// Filled anew, since Tpetra wants the owned columns in front.
RCP<const CrsMatrix> withColumnsOn(RCP<const Map> const& owners, CrsMatrix const& P)
{
  const auto result = rcp(new CrsMatrix(P.getRowMap(), maxLocalRowEntries(P)));
  const auto local = P.getLocalMatrixHost();
  std::vector<GlobalOrdinal> columns;
  for (LocalOrdinal k = 0; k < static_cast<LocalOrdinal>(numLocalRows(P)); ++k) {
    const auto row = local.rowConst(k);
    columns.clear();
    for (int i = 0; i < row.length; ++i) {
      columns.push_back(P.getColMap()->getGlobalElement(row.colidx(i)));
    }
    if (row.length > 0) {
      result->insertGlobalValues(P.getRowMap()->getGlobalElement(k), row.length, &row.value(0),
                                 columns.data());
    }
  }
  result->fillComplete(owners, P.getRangeMap());
  return result;
}

RCP<const CrsMatrix> movedTo(RCP<const Map> const& owners, RCP<const CrsMatrix> const& A)
{
  return Tpetra::importAndFillCompleteCrsMatrix<CrsMatrix>(A, Import(A->getRowMap(), owners),
                                                           owners, owners);
}

RCP<const MultiVector> movedTo(RCP<const Map> const& owners, MultiVector const& x)
{
  const auto result = rcp(new MultiVector(owners, x.getNumVectors()));
  result->doImport(x, Import(x.getMap(), owners), Tpetra::INSERT);
  return result;
}
} // namespace asperity::tnnmg::detail
