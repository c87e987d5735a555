#include "base/program/WorkTimers.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

using namespace asperity;

namespace
{
void rest(int milliseconds)
{
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

void workLong()
{
  ASPERITY_TIME_WORK("long work");
  rest(60);
}

void workShort()
{
  ASPERITY_TIME_WORK("short work");
  rest(5);
}

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
std::vector<double> numbersOf(std::string const& table, std::string const& name)
{
  std::istringstream text(lineOf(table, name).substr(32));
  double least = 0, most = 0, share = 0, count = 0;
  std::string percent;
  text >> least >> most >> share >> percent >> count;
  return {least, most, share, count};
}
} // namespace

TEST(WorkTimers, TabulateTheKindsOfWorkTheLongestFirst)
{
  const Teuchos::MpiComm<int> ranks(MPI_COMM_WORLD);
  for (int i = 0; i < 3; ++i) {
    workShort();
  }
  workLong();
  { // as long on rank 0 alone
    ASPERITY_TIME_WORK("work of rank 0");
    rest(ranks.getRank() == 0 ? 50 : 0);
  }
  workTimer("never done");
  Teuchos::TimeMonitor::getNewCounter("a timer of Trilinos");
  const auto table = tableOfWork(ranks);
  EXPECT_LT(table.find("long work"), table.find("short work")) << table;
  EXPECT_EQ(lineOf(table, "never done"), "") << table;
  EXPECT_EQ(table.find("Trilinos"), std::string::npos) << table;
  EXPECT_EQ(numbersOf(table, "short work")[3], 3) << table;
  EXPECT_GE(numbersOf(table, "long work")[0], 0.06) << table;
  auto const uneven = numbersOf(table, "work of rank 0");
  EXPECT_GE(uneven[1], 0.05) << table;
  EXPECT_EQ(uneven[0]<0.05, ranks.getSize()> 1) << table;
  auto const whole = numbersOf(table, "whole run");
  EXPECT_EQ(whole[2], 100) << table;
  EXPECT_GE(whole[1], numbersOf(table, "long work")[1]);
}

TEST(WorkTimers, AreOneForEachName)
{
  EXPECT_EQ(workTimer("the same").get(), workTimer("the same").get());
  EXPECT_NE(workTimer("the same").get(), workTimer("another").get());
}

// The best of several, because other programs may use the core at the same time.
TEST(WorkTimers, CostLittle)
{
  if (std::getenv("ASPERITY_SANITIZER")) {
    GTEST_SKIP() << "With a sanitizer nothing costs little.";
  }
  double best = 1.0;
  for (int attempt = 0; attempt < 20; ++attempt) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 10000; ++i) {
      ASPERITY_TIME_WORK("hardly any work");
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    best = std::min(best, elapsed.count() / 10000);
  }
  EXPECT_LT(best, 500e-9);
  RecordProperty("nanoseconds_per_scope", static_cast<int>(best * 1e9));
}
