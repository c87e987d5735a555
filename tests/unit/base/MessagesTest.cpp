#include "base/parallel/Messages.hpp"

#include "unit/base/Refusal.hpp"

#include <Teuchos_DefaultComm.hpp>
#include <gtest/gtest.h>

#include <limits>

using namespace asperity;

// Every rank sends rank r so many items: r + 1.
TEST(Messages, ItemsArriveInTheOrderOfTheRanks)
{
  const auto world = Teuchos::DefaultComm<int>::getComm();
  const int rank = world->getRank(), size = world->getSize();
  std::vector<GlobalOrdinal> items;
  std::vector<int> destinations;
  for (int to = 0; to < size; ++to) {
    for (int i = 0; i <= to; ++i) {
      items.insert(items.end(), {rank, i});
      destinations.push_back(to);
    }
  }
  std::vector<GlobalOrdinal> expected;
  for (int from = 0; from < size; ++from) {
    for (int i = 0; i <= rank; ++i) {
      expected.insert(expected.end(), {from, i});
    }
  }
  EXPECT_EQ(sendItems(items, 2, destinations, *world), expected);
}

// What an int cannot count is refused, and not sent with a count that has overflowed.
TEST(Messages, OffsetsStopAtWhatAnIntCounts)
{
  EXPECT_EQ(blockOffsets({3, 0, 4}, "A test"), (std::vector<int>{0, 3, 3, 7}));
  const std::int64_t largest = std::numeric_limits<int>::max();
  EXPECT_EQ(blockOffsets({largest - 1, 1}, "A test").back(), largest);
  const std::vector<std::int64_t> too_many{largest, 1};
  const auto message = test::refusal([&] { blockOffsets(too_many, "A test"); });
  EXPECT_EQ(message.rfind("A test would have 2147483648 numbers", 0), 0u) << message;
}

// Past 2 GiB an int has overflowed.
TEST(Messages, PiecesOfManyGigabytesAreCounted)
{
  const auto five_gib = (std::uint64_t(5) << 30) + 3;
  const Pieces pieces(five_gib, largest_piece);
  EXPECT_EQ(pieces.count(), 6u);
  EXPECT_EQ(pieces.first(5), std::uint64_t(5) << 30);
  EXPECT_EQ(pieces.size(4), 1 << 30);
  EXPECT_EQ(pieces.size(5), 3);
  EXPECT_EQ(Pieces(0, largest_piece).count(), 0u);
}
