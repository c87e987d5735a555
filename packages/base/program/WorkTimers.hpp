#pragma once

#include "base/Types.hpp"

#include <Teuchos_TimeMonitor.hpp>

#include <string>
#include <vector>

// Times the rest of the block as one kind of work of the run, at the price of reading the clock
// twice. One host thread; a name may be used in several places.
//   ASPERITY_TIME_WORK("line search");
#define ASPERITY_TIME_WORK(name)                                                                   \
  static auto const asperity_work = ::asperity::workTimer(name);                                   \
  ::asperity::TimedWork const asperity_timed_work(*asperity_work)

// The same name for the rest of the block without a clock, for work within a kind of work.
#define ASPERITY_NAME_WORK(name) ::asperity::NamedWork const asperity_named_work(name)

namespace asperity
{
// The timer of a kind of work, one for each name.
RCP<Teuchos::Time> workTimer(std::string const& name);

// The innermost name of the work in progress, "" if it has none; for programs that count
// operations.
char const* currentWork();

class NamedWork
{
public:
  explicit NamedWork(char const* name);
  ~NamedWork();
  NamedWork(NamedWork const&) = delete;
  NamedWork& operator=(NamedWork const&) = delete;

private:
  char const* before_;
};

// Runs a timer while it lives. Teuchos::TimeMonitor does the same and reports to a stacked timer,
// too, which takes as long as some of the work that is timed here.
class TimedWork
{
public:
  explicit TimedWork(Teuchos::Time& timer);
  ~TimedWork()
  {
    timer_.stop();
    timer_.incrementNumCalls();
  }
  TimedWork(TimedWork const&) = delete;
  TimedWork& operator=(TimedWork const&) = delete;

private:
  Teuchos::Time& timer_;
  NamedWork named_;
};

// The wall time [s] since this process began.
double secondsSinceStart();

// A kind of work on all ranks.
struct WorkOfRanks
{
  std::string name;
  double least = 0, most = 0; // time on a rank [s]
  double count = 0;           // how often it was done, at most
};

// One line for each kind of work in a run of `total` seconds, the longest first. Kinds do not
// contain each other; what belongs to none of them stands last.
std::string tableOf(std::vector<WorkOfRanks> work, double total);

// The table of all work that was done since this process began. Collective, for rank 0 to print.
std::string tableOfWork(Communicator const& communicator);
} // namespace asperity
