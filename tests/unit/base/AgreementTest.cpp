#include "base/parallel/Agreement.hpp"

#include "unit/base/Refusal.hpp"

#include <Teuchos_DefaultComm.hpp>
#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>

using namespace asperity;

namespace
{
Communicator const& world()
{
  static const RCP<const Communicator> communicator = Teuchos::DefaultComm<int>::getComm();
  return *communicator;
}

int last() { return world().getSize() - 1; }

// The message of what the last rank alone throws, as this rank gets it.
template <class Error, class Agree>
std::string caught(Agree agree, Error const& error, int thrower)
{
  try {
    agree(world(), [&] {
      if (world().getRank() == thrower) {
        throw error;
      }
    });
  } catch (Error const& shared) {
    return shared.what();
  }
  return "";
}

template <class Agree>
void expectItsKindOnEveryRank(Agree agree, int thrower)
{
  EXPECT_EQ(caught(agree, InputError("a = -1"), thrower), "a = -1");
  EXPECT_EQ(caught(agree, SolveError("no root"), thrower), "no root");
  EXPECT_EQ(caught(agree, UselessRun("lost"), thrower), "lost");
  EXPECT_EQ(caught(agree, OutputError("disk full"), thrower), "disk full");
  EXPECT_EQ(caught(agree, std::runtime_error("what else"), thrower), "what else");
  EXPECT_NE(caught(agree, std::bad_alloc(), thrower), "");
}
} // namespace

TEST(Agreement, ErrorOfOneRankIsThrownOnEveryRankAsItsKind)
{
  expectItsKindOnEveryRank(
    [](Communicator const& communicator, std::function<void()> const& work) {
      onEveryRank(communicator, work);
    },
    last());
  expectItsKindOnEveryRank(onRoot, 0);
}

TEST(Agreement, LowestRankSpeaks)
{
  const auto message = asperity::test::refusal([] {
    onEveryRank(world(), [] { throw InputError("rank " + std::to_string(world().getRank())); });
  });
  EXPECT_EQ(message, "rank 0");
}

TEST(Agreement, NothingIsThrownWhereNothingIsWrong)
{
  int num_calls = 0;
  onEveryRank(world(), [&] { ++num_calls; });
  onRoot(world(), [&] { ++num_calls; });
  EXPECT_EQ(num_calls, world().getRank() == 0 ? 2 : 1);
}
