#include "base/parallel/GhostExchange.hpp"

#include "base/Errors.hpp"

#include <Tpetra_Core.hpp>
#include <Tpetra_Map.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace asperity
{
namespace
{
constexpr int owned_ids = 4; // of each rank, one after the other

// Every rank has copies of two items of the next rank and of the last of the one before.
struct Ring
{
  Ring()
      : communicator(Tpetra::getDefaultComm())
      , map(owned_ids * communicator->getSize(), owned_ids, 0, communicator)
      , ghosts(ghostsOf(communicator->getRank(), communicator->getSize()))
      , exchange(map, ghosts)
  {
  }

  static std::vector<GlobalOrdinal> ghostsOf(int rank, int num_ranks)
  {
    if (num_ranks == 1) {
      return {};
    }
    const int next = (rank + 1) % num_ranks, last = (rank + num_ranks - 1) % num_ranks;
    return {owned_ids * next + 1, owned_ids * last + 3, owned_ids * next};
  }
  std::size_t numItems() const { return owned_ids + ghosts.size(); }
  GlobalOrdinal id(std::size_t item) const
  {
    return item < owned_ids ? map.getGlobalElement(static_cast<LocalOrdinal>(item))
                            : ghosts[item - owned_ids];
  }

  RCP<const Communicator> communicator;
  Map map;
  std::vector<GlobalOrdinal> ghosts;
  GhostExchange exchange;
};

template <class T>
using Values = Kokkos::View<T*, MemorySpace>;

template <class T>
T valueOf(GlobalOrdinal id, int k)
{
  return static_cast<T>(100 * (id + 1) + k);
}

// The ghosts after values that depend on the ids have been shared, (num_ghosts width); -1 where
// none came.
template <class T>
std::vector<T> shared(Ring const& ring, GhostExchange const& exchange, int width)
{
  std::vector<T> values(ring.numItems() * width, -1);
  for (int item = 0; item < owned_ids; ++item) {
    for (int k = 0; k < width; ++k) {
      values[item * width + k] = valueOf<T>(ring.id(item), k);
    }
  }
  auto const view = toDevice(values, "values");
  exchange.share<T>(view, width);
  auto const all = toVector(view);
  return {all.begin() + owned_ids * width, all.end()};
}

template <class T>
void expectShared(Ring const& ring, int width)
{
  auto const ghosts = shared<T>(ring, ring.exchange, width);
  for (std::size_t i = 0; i < ghosts.size(); ++i) {
    const auto k = static_cast<int>(i % width);
    EXPECT_EQ(ghosts[i], valueOf<T>(ring.ghosts[i / width], k)) << i << " of width " << width;
  }
}
} // namespace

TEST(GhostExchange, SharesOwnedValues)
{
  const Ring ring;
  for (int width : {1, 3, 2}) { // more than before, and fewer
    expectShared<float>(ring, width);
    expectShared<double>(ring, width);
  }
}

// Three items have one copy each. With the values of the ghosts from another vector.
TEST(GhostExchange, GathersWhatGhostsHave)
{
  const Ring ring;
  for (int width : {1, 2}) {
    const auto from = toDevice(std::vector<float>(ring.numItems() * width, 2), "from");
    const Values<float> into("into", owned_ids * width);
    ring.exchange.gather<float>(from, -1, into, width);
    const float each = ring.communicator->getSize() > 1 ? -2 : 0;
    auto const sums = toVector(into);
    for (int item = 0; item < owned_ids; ++item) {
      for (int k = 0; k < width; ++k) {
        EXPECT_EQ(sums[item * width + k], item == 2 ? 0 : each);
      }
    }
  }
}

// All other ranks have copies of what rank 0 owns; they are added in the order of ranks, which
// shows where rounding depends on it.
TEST(GhostExchange, AddsInTheOrderOfRanks)
{
  auto const communicator = Tpetra::getDefaultComm();
  const int rank = communicator->getRank(), size = communicator->getSize();
  const Map map(1, rank == 0 ? 1 : 0, 0, communicator);
  const GhostExchange exchange(map, rank == 0 ? std::vector<GlobalOrdinal>{}
                                              : std::vector<GlobalOrdinal>{0});
  const auto term = [](int of_rank) { return of_rank == 0 ? 1e16 : of_rank % 2 == 1 ? 1. : -1e16; };
  const auto x = toDevice(std::vector<double>(1, term(rank)), "x");
  exchange.gather<double>(x, 1, x);
  double expected = term(0);
  for (int other = 1; other < size; ++other) {
    expected += term(other);
  }
  EXPECT_EQ(toVector(x).front(), rank == 0 ? expected : term(rank));
}

// All other ranks have copies of what rank 0 owns.
TEST(GhostExchange, GathersTheLargest)
{
  auto const communicator = Tpetra::getDefaultComm();
  const int rank = communicator->getRank(), size = communicator->getSize();
  const Map map(2, rank == 0 ? 2 : 0, 0, communicator);
  const GhostExchange exchange(map, rank == 0 ? std::vector<GlobalOrdinal>{}
                                              : std::vector<GlobalOrdinal>{0, 1});
  // The first grows with the rank, the second falls; both are negative.
  const std::vector<double> mine = {rank - 10., -rank - 1.};
  const auto x = toDevice(mine, "x");
  exchange.gatherLargest<double>(x, x);
  EXPECT_EQ(toVector(x), rank == 0 ? (std::vector<double>{size - 11., -1}) : mine);
}

TEST(GhostExchange, SendsOnlyWhatIsTaken)
{
  const Ring ring;
  const auto by_owner = ring.exchange.withOwned({1, 0, 1, 0}); // the first and the third item
  auto const of_owner = shared<double>(ring, by_owner, 1);
  std::vector<char> wanted(ring.ghosts.size(), 0);
  for (std::size_t i = 0; i < of_owner.size(); ++i) {
    EXPECT_EQ(of_owner[i] > 0, ring.ghosts[i] % owned_ids == 0);
    wanted[i] = i == 1;
  }
  auto const of_ghosts = shared<double>(ring, ring.exchange.withGhosts(wanted), 1);
  for (std::size_t i = 0; i < of_ghosts.size(); ++i) {
    EXPECT_EQ(of_ghosts[i] > 0, i == 1);
  }
}

TEST(GhostExchange, FollowsNewNumbersOfOwnedItems)
{
  const Ring ring;
  const auto turned = ring.exchange.renumbered({3, 2, 1, 0});
  const Values<double> x("x", ring.numItems());
  auto const own = Kokkos::create_mirror_view(x);
  for (int item = 0; item < owned_ids; ++item) {
    own(3 - item) = valueOf<double>(ring.id(item), 0);
  }
  Kokkos::deep_copy(x, own);
  turned.share<double>(x);
  auto const all = toVector(x);
  for (std::size_t i = 0; i < ring.ghosts.size(); ++i) {
    EXPECT_EQ(all[owned_ids + i], valueOf<double>(ring.ghosts[i], 0));
  }
}

TEST(GhostExchange, RefusesWhatNobodyOwns)
{
  const Ring ring;
  if (ring.communicator->getSize() > 1) {
    EXPECT_THROW(GhostExchange(ring.map, {owned_ids * 1000}), InputError);
  }
}
} // namespace asperity
