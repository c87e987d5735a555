#include "base/parallel/Directory.hpp"

#include <Teuchos_DefaultComm.hpp>
#include <gtest/gtest.h>

using namespace asperity;

namespace
{
constexpr GlobalOrdinal num_ids = 11; // in blocks of 11, 6 and 4 on 1, 2 and 3 ranks
using Numbers = std::vector<GlobalOrdinal>;

// Even ids but 4, dealt out by turns, the largest one first.
Numbers idsOfRank(Communicator const& comm)
{
  Numbers ids;
  for (const GlobalOrdinal id : {10, 8, 6, 2, 0}) {
    if (id / 2 % comm.getSize() == comm.getRank()) {
      ids.push_back(id);
    }
  }
  return ids;
}

struct DirectoryOfTen : ::testing::Test
{
  const Teuchos::RCP<const Communicator> world = Teuchos::DefaultComm<int>::getComm();
  const Directory directory{num_ids, *world};
  const Numbers ids = idsOfRank(*world);
};
} // namespace

TEST_F(DirectoryOfTen, HasTheValueOfEachId)
{
  Numbers values;
  for (const GlobalOrdinal id : ids) {
    values.push_back(100 + id);
  }
  EXPECT_EQ(directory.valuesAt({10, 0, 4, 7, 2, 2}, ids, values),
            (Numbers{110, 100, -1, -1, 102, 102}));
}

TEST_F(DirectoryOfTen, SumsTheValuesOfSmallerIds)
{
  const Numbers values = ids; // 0 + 2 + 6 + 8 + 10
  const Numbers asked = world->getRank() == 0 ? Numbers{} : Numbers{10, 0, 4, 5, 6, 7, 2};
  const Numbers sums = world->getRank() == 0 ? Numbers{} : Numbers{16, 0, 2, 2, 2, 8, 0};
  EXPECT_EQ(directory.sumsBefore(asked, ids, values), sums);
  EXPECT_EQ(directory.sumsBefore({9}, ids, values), Numbers{16});
}
