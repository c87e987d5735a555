#include "base/program/WorkTimers.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

using namespace asperity;

namespace
{
using Numbers = std::vector<double>;

std::string lineOf(std::string const& table, std::string const& name)
{
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(name, 0) == 0) {
      return line;
    }
  }
  return "";
}

// The numbers of a line behind its name: smallest, largest, share, count.
Numbers numbersOf(std::string const& table, std::string const& name)
{
  auto const line = lineOf(table, name);
  std::istringstream text(line.substr(line.empty() ? 0 : 32));
  double least = 0, most = 0, share = 0, count = 0;
  std::string percent;
  text >> least >> most >> share >> percent >> count;
  return {least, most, share, count};
}

void repeatedWork() { ASPERITY_TIME_WORK("repeated work"); }
} // namespace

TEST(WorkTimers, TabulateTheKindsOfWorkTheLongestFirst)
{
  const auto table = tableOf({{"short work", 0.5, 1, 3}, {"long work", 2, 4, 1}}, 10);
  EXPECT_LT(table.find("long work"), table.find("short work")) << table;
  EXPECT_EQ(numbersOf(table, "long work"), (Numbers{2, 4, 40, 1})) << table;
  EXPECT_EQ(numbersOf(table, "short work"), (Numbers{0.5, 1, 10, 3})) << table;
  EXPECT_EQ(numbersOf(table, "other"), (Numbers{5, 7.5, 75, 1})) << table;
  EXPECT_EQ(numbersOf(table, "whole run"), (Numbers{10, 10, 100, 1})) << table;
}

TEST(WorkTimers, RunToTheEndOfTheBlock)
{
  auto const timer = workTimer("timed work");
  {
    ASPERITY_TIME_WORK("timed work");
    EXPECT_TRUE(timer->isRunning());
    EXPECT_STREQ(currentWork(), "timed work");
  }
  EXPECT_FALSE(timer->isRunning());
  EXPECT_STREQ(currentWork(), "");
  EXPECT_EQ(timer->numCalls(), 1);
}

TEST(WorkTimers, AreTabulatedForAllRanks)
{
  const Teuchos::MpiComm<int> ranks(MPI_COMM_WORLD);
  for (int i = 0; i < 3; ++i) {
    repeatedWork();
  }
  auto const timer = workTimer("work of rank 0");
  if (ranks.getRank() == 0) {
    TimedWork const timed(*timer);
    while (timer->totalElapsedTime(true) < 0.02) { // what the table shows of it
    }
  }
  workTimer("never done");
  Teuchos::TimeMonitor::getNewCounter("a timer of Trilinos");
  const auto table = tableOfWork(ranks);
  EXPECT_EQ(numbersOf(table, "repeated work")[3], 3) << table;
  auto const uneven = numbersOf(table, "work of rank 0");
  EXPECT_GE(uneven[1], 0.02) << table;
  EXPECT_EQ(uneven[0], ranks.getSize() > 1 ? 0 : uneven[1]) << table;
  EXPECT_EQ(uneven[3], 1) << table;
  EXPECT_EQ(lineOf(table, "never done"), "") << table;
  EXPECT_EQ(table.find("Trilinos"), std::string::npos) << table;
  auto const whole = numbersOf(table, "whole run");
  EXPECT_EQ(whole[2], 100) << table;
  EXPECT_GE(whole[1], uneven[1]) << table;
}

TEST(WorkTimers, AreOneForEachName)
{
  EXPECT_EQ(workTimer("the same").get(), workTimer("the same").get());
  EXPECT_NE(workTimer("the same").get(), workTimer("another").get());
}
