#include "tnnmg/hierarchy/FewerRanks.hpp"

#include "base/parallel/Reductions.hpp"
#include "portability/Renamed.hpp"

#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Vector.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace asperity::tnnmg
{
namespace
{
constexpr int size = 30; // rows

RCP<const Map> rows() { return rcp(new Map(size, 0, Tpetra::getDefaultComm())); }

// Symmetric, with couplings of each row to the next two.
RCP<const CrsMatrix> band()
{
  const auto A = rcp(new CrsMatrix(rows(), 5));
  for (std::size_t k = 0; k < numLocalElements(*A->getRowMap()); ++k) {
    const auto row = A->getRowMap()->getGlobalElement(static_cast<int>(k));
    for (GlobalOrdinal column = row - 2; column <= row + 2; ++column) {
      if (column >= 0 && column < size) {
        const double value = 1. + static_cast<double>(row * column);
        A->insertGlobalValues(row, 1, &value, &column);
      }
    }
  }
  A->fillComplete();
  return A;
}

Vector wave(RCP<const Map> const& map)
{
  Vector x(map);
  const auto values = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t k = 0; k < numLocalElements(*map); ++k) {
    values(k, 0) = std::sin(1. + static_cast<double>(map->getGlobalElement(static_cast<int>(k))));
  }
  return x;
}

int ranksWithRows(Map const& map)
{
  return sumOverRanks(numLocalElements(map) > 0 ? 1 : 0, *map.getComm());
}
} // namespace

TEST(FewerRanks, LeavesLevelsThatHaveEnoughRows)
{
  const int ranks = Tpetra::getDefaultComm()->getSize();
  EXPECT_TRUE(detail::onFewerRanks(*rows(), size / ranks).is_null());
  EXPECT_TRUE(detail::onFewerRanks(*rows(), 0).is_null());
}

TEST(FewerRanks, JoinSuccessiveRanks)
{
  const int ranks = Tpetra::getDefaultComm()->getSize();
  for (int rows_per_rank : {11, 1000}) {
    const auto owners = detail::onFewerRanks(*rows(), rows_per_rank);
    if (ranks == 1 || (ranks == 2 && rows_per_rank == 11)) {
      EXPECT_TRUE(owners.is_null());
      continue;
    }
    ASSERT_FALSE(owners.is_null());
    EXPECT_EQ(owners->getGlobalNumElements(), std::size_t(size));
    EXPECT_TRUE(owners->isOneToOne());
    // Of three ranks with ten rows each two with 15 on average are left, else one.
    EXPECT_EQ(ranksWithRows(*owners), rows_per_rank == 11 ? 2 : 1);
    for (std::size_t k = 1; k < numLocalElements(*owners); ++k) {
      const int row = static_cast<int>(k);
      EXPECT_EQ(owners->getGlobalElement(row), owners->getGlobalElement(row - 1) + 1);
    }
    // A level that has moved may move again.
    if (rows_per_rank == 11) {
      const auto again = detail::onFewerRanks(*owners, 1000);
      ASSERT_FALSE(again.is_null());
      EXPECT_EQ(ranksWithRows(*again), 1);
    }
  }
}

TEST(FewerRanks, MatricesKeepTheirEntries)
{
  const auto owners = detail::onFewerRanks(*rows(), 1000);
  if (owners.is_null()) {
    return; // one rank
  }
  const auto A = band();
  Vector expected(A->getRowMap());
  A->apply(wave(A->getRowMap()), expected);
  const auto P = detail::withColumnsOn(owners, *A);
  EXPECT_TRUE(P->getDomainMap()->isSameAs(*owners));
  Vector y(A->getRowMap());
  P->apply(wave(owners), y);
  y.update(-1, expected, 1);
  EXPECT_LE(y.normInf(), 1e-14 * expected.normInf());

  const auto moved = detail::movedTo(owners, A);
  Vector on_one(owners);
  moved->apply(wave(owners), on_one);
  const auto all = detail::movedTo(owners, expected);
  on_one.update(-1, *all->getVector(0), 1);
  EXPECT_LE(on_one.normInf(), 1e-14 * expected.normInf());
}
} // namespace asperity::tnnmg
