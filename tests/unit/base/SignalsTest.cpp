#include "base/program/Signals.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace
{
using namespace asperity;

TEST(Signals, AllRanksLearnOfASignalToOne)
{
  const Teuchos::MpiComm<int> communicator(MPI_COMM_WORLD);
  const int last = communicator.getSize() - 1;
  StopSignals signals;
  const bool is_last = communicator.getRank() == last;
  EXPECT_EQ(signals.agreed(false, communicator).signal, 0);
  EXPECT_FALSE(signals.agreed(false, communicator).wished);
  EXPECT_EQ(signals.agreed(is_last, communicator).signal, 0);
  EXPECT_TRUE(signals.agreed(is_last, communicator).wished);
  if (is_last) {
    std::raise(SIGTERM);
  }
  EXPECT_EQ(signals.received(), is_last ? SIGTERM : 0);
  EXPECT_EQ(signals.agreed(false, communicator).signal, SIGTERM);
  EXPECT_EQ(signals.agreed(true, communicator).signal, SIGTERM);
}

TEST(Signals, WarningsOfQueuesAreNoted)
{
  StopSignals signals;
  for (const int number : {SIGUSR1, SIGUSR2, SIGXCPU}) {
    std::raise(number);
    EXPECT_EQ(signals.received(), number);
  }
  EXPECT_EQ(signalName(SIGUSR2), "SIGUSR2");
  EXPECT_EQ(signalName(SIGXCPU), "SIGXCPU");
}

TEST(Signals, InterruptIsNotedOnceAndEndsTheProcessTheSecondTime)
{
  StopSignals signals;
  std::raise(SIGINT);
  EXPECT_EQ(signals.received(), SIGINT);
  struct sigaction action;
  sigaction(SIGINT, nullptr, &action);
  EXPECT_NE(action.sa_handler, SIG_DFL);
}

volatile std::sig_atomic_t caught_by_previous = 0;
extern "C" void previousHandler(int) { caught_by_previous = 1; }

TEST(Signals, PreviousHandlersComeBack)
{
  const auto original = std::signal(SIGTERM, previousHandler);
  {
    StopSignals signals;
    std::raise(SIGTERM);
    EXPECT_EQ(caught_by_previous, 0);
  }
  std::raise(SIGTERM);
  EXPECT_EQ(caught_by_previous, 1);
  std::signal(SIGTERM, original);
  EXPECT_EQ(StopSignals().received(), 0);
}

TEST(Signals, WhatWasIgnoredAtTheStartStaysIgnored)
{
  for (const int number : {SIGHUP, SIGPIPE}) {
    const auto original = std::signal(number, SIG_IGN);
    noteIgnoredSignals(0, nullptr, nullptr);
    std::signal(number, previousHandler); // as a library does
    caught_by_previous = 0;
    {
      StopSignals signals;
      std::raise(number);
      EXPECT_EQ(signals.received(), 0) << number;
    }
    std::raise(number);
    EXPECT_EQ(caught_by_previous, 0) << number;
    std::signal(number, original);
    noteIgnoredSignals(0, nullptr, nullptr);
  }
}

TEST(Signals, OneWatcherAtATime)
{
  StopSignals signals;
  EXPECT_THROW(StopSignals(), std::logic_error);
}
} // namespace
