#include "base/parallel/FirstRank.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace
{
using namespace asperity;

using Place = std::optional<std::array<double, 2>>;

TEST(FirstRank, IsTheLowestOneOrNone)
{
  const Teuchos::MpiComm<int> ranks(MPI_COMM_WORLD);
  const int rank = ranks.getRank(), last = ranks.getSize() - 1;
  EXPECT_EQ(firstRankWhere(true, ranks), std::optional<int>(0));
  EXPECT_EQ(firstRankWhere(rank == last, ranks), std::optional<int>(last));
  EXPECT_EQ(firstRankWhere(false, ranks), std::nullopt);
}

TEST(FirstRank, GivesItsNumbersToAll)
{
  const Teuchos::MpiComm<int> ranks(MPI_COMM_WORLD);
  const int rank = ranks.getRank(), last = ranks.getSize() - 1;
  const Place mine = {{0.1 + rank, -2e30 * (rank + 1)}};
  EXPECT_EQ(ofFirstRank(mine, ranks), (Place{{0.1, -2e30}})) << "not the sum of several";
  EXPECT_EQ(ofFirstRank(rank == last ? mine : Place(), ranks),
            (Place{{0.1 + last, -2e30 * (last + 1)}}));
  EXPECT_EQ(ofFirstRank(Place(), ranks), Place());
}
} // namespace
