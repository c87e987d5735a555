#include "base/parallel/Reductions.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace
{
using namespace asperity;

TEST(Reductions, GiveEveryRankTheSumTheLargestAndTheSmallest)
{
  const Teuchos::MpiComm<int> ranks(MPI_COMM_WORLD);
  const int rank = ranks.getRank();
  const int size = ranks.getSize();
  EXPECT_EQ(sumOverRanks(rank + 1, ranks), size * (size + 1) / 2);
  EXPECT_EQ(sumOverRanks(0.5, ranks), 0.5 * size);
  EXPECT_EQ(maxOverRanks(rank - 0.25, ranks), size - 1.25);
  EXPECT_EQ(minOverRanks(10 - rank, ranks), 11 - size);
}

TEST(Reductions, TakeSeveralNumbersEntryByEntry)
{
  const Teuchos::MpiComm<int> ranks(MPI_COMM_WORLD);
  const int rank = ranks.getRank();
  const int size = ranks.getSize();
  EXPECT_EQ(maxOverRanks(std::vector<int>{rank, -rank}, ranks), (std::vector<int>{size - 1, 0}));
  const std::array<double, 2> mine = {0.5, 1. * rank};
  EXPECT_EQ(sumOverRanks(mine, ranks), (std::array<double, 2>{0.5 * size, size * (size - 1) / 2.}));
  EXPECT_TRUE(minOverRanks(std::vector<double>(), ranks).empty());
}

TEST(Reductions, CountBeyondThirtyTwoBits)
{
  const Teuchos::MpiComm<int> ranks(MPI_COMM_WORLD);
  const std::int64_t many = std::int64_t(1) << 60;
  EXPECT_EQ(sumOverRanks(many, ranks) / ranks.getSize(), many);
  EXPECT_EQ(sumOverRanks(GlobalOrdinal(3) << 40, ranks) / ranks.getSize(), GlobalOrdinal(3) << 40);
}

TEST(Reductions, LeaveTheNumberOfASingleRankAlone)
{
  const Teuchos::SerialComm<int> alone;
  EXPECT_EQ(sumOverRanks(7, alone), 7);
  EXPECT_EQ(maxOverRanks(-7., alone), -7.);
}
} // namespace
