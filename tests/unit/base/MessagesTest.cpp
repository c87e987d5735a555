#include "base/parallel/Messages.hpp"

#include <Teuchos_DefaultComm.hpp>
#include <gtest/gtest.h>

using namespace asperity;

// More bytes than one message may have go in pieces, whatever the size of the last.
TEST(Messages, BytesArriveInPieces)
{
  const auto world = Teuchos::DefaultComm<int>::getComm();
  const int last = world->getSize() - 1;
  for (const std::size_t size : {0, 1, 6, 7, 8, 21, 1000}) {
    std::vector<char> bytes;
    for (std::size_t i = 0; i < size; ++i) {
      bytes.push_back(static_cast<char>(i % 251));
    }
    if (last > 0 && world->getRank() == last) {
      sendBytes(bytes, 0, *world, 7);
    }
    if (last > 0 && world->getRank() == 0) {
      EXPECT_EQ(receiveBytes(last, *world, 7), bytes);
    }
  }
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
