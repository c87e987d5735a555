#include "tnnmg/Halo.hpp"

#include "base/Errors.hpp"

#include <Tpetra_Core.hpp>
#include <Tpetra_Map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace asperity::tnnmg
{
namespace
{
constexpr int owned_ids = 4; // of each rank, one after the other

// Every rank has copies of two numbers of the next rank and of the last of the one before.
struct Ring
{
  Ring()
      : communicator(Tpetra::getDefaultComm())
      , map(owned_ids * communicator->getSize(), owned_ids, 0, communicator)
      , ghosts(ghostsOf(communicator->getRank(), communicator->getSize()))
      , halo(map, ghosts)
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
  GlobalOrdinal id(int local) const { return map.getGlobalElement(local); }

  RCP<const Communicator> communicator;
  Map map;
  std::vector<GlobalOrdinal> ghosts;
  Halo halo;
};

// What the ghosts are after a value that depends on the id has been shared; -1 where none came.
std::vector<double> shared(Ring const& ring, Halo const& halo)
{
  std::vector<double> sent, received(halo.received().size());
  for (const int place : halo.sent()) {
    sent.push_back(100. + static_cast<double>(ring.id(place)));
  }
  halo.share(sent.data(), received.data());
  std::vector<double> ghosts(ring.ghosts.size(), -1.);
  for (std::size_t i = 0; i < received.size(); ++i) {
    ghosts[halo.received()[i]] = received[i];
  }
  return ghosts;
}
} // namespace

TEST(Halo, SharesOwnedValues)
{
  const Ring ring;
  auto const ghosts = shared(ring, ring.halo);
  for (std::size_t i = 0; i < ghosts.size(); ++i) {
    EXPECT_EQ(ghosts[i], 100. + static_cast<double>(ring.ghosts[i]));
  }
}

TEST(Halo, GathersWhatGhostsHave)
{
  const Ring ring;
  std::vector<float> copies(ring.halo.received().size(), 1), came(ring.halo.sent().size());
  ring.halo.gather(copies.data(), came.data());
  std::vector<float> sums(owned_ids, 0);
  for (std::size_t i = 0; i < came.size(); ++i) {
    sums[ring.halo.sent()[i]] += came[i];
  }
  const float each = ring.communicator->getSize() > 1 ? 1 : 0;
  EXPECT_EQ(sums, (std::vector<float>{each, each, 0, each}));
}

TEST(Halo, SendsOnlyWhatIsTaken)
{
  const Ring ring;
  const Halo by_owner = ring.halo.withOwned({1, 0, 1, 0}); // the first and the third number
  EXPECT_EQ(std::count(by_owner.sent().begin(), by_owner.sent().end(), 0),
            ring.ghosts.empty() ? 0 : 1);
  auto const of_owner = shared(ring, by_owner);
  std::vector<char> wanted(ring.ghosts.size(), 0);
  for (std::size_t i = 0; i < of_owner.size(); ++i) {
    EXPECT_EQ(of_owner[i] > 0, ring.ghosts[i] % owned_ids == 0);
    wanted[i] = i == 1;
  }
  auto const of_ghosts = shared(ring, ring.halo.withGhosts(wanted));
  for (std::size_t i = 0; i < of_ghosts.size(); ++i) {
    EXPECT_EQ(of_ghosts[i] > 0, i == 1);
  }
}

TEST(Halo, RefusesWhatNobodyOwns)
{
  const Ring ring;
  if (ring.communicator->getSize() > 1) {
    EXPECT_THROW(Halo(ring.map, {owned_ids * 1000}), InputError);
  }
}
} // namespace asperity::tnnmg
