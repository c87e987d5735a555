#include "base/parallel/Reductions.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <gtest/gtest.h>

#include <cstdint>

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
