#include "base/program/WorkTimers.hpp"

#include "base/Text.hpp"
#include "base/parallel/Reductions.hpp"

#include <algorithm>
#include <chrono>
#include <map>

namespace asperity
{
namespace
{
const auto program_start = std::chrono::steady_clock::now();

// Distinguishes these timers from those of Trilinos.
const std::string prefix = "asperity: ";

std::vector<WorkOfRanks> workDone(Communicator const& communicator)
{
  Teuchos::stat_map_type statistics;
  std::vector<std::string> names;
  Teuchos::TimeMonitor::computeGlobalTimerStatistics(
    statistics, names, Teuchos::ptrFromRef(communicator), Teuchos::Union, prefix);
  const auto place = [&](char const* name) {
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  const auto least = place("MinOverProcs"), most = place("MaxOverProcs");
  std::vector<WorkOfRanks> work;
  for (auto const& [label, values] : statistics) {
    if (values[most].second > 0) {
      work.push_back({label.substr(prefix.size()), values[least].first, values[most].first,
                      values[most].second});
    }
  }
  return work;
}

std::string line(WorkOfRanks const& row, double total)
{
  return formatted("%-32s%10.2f %10.2f %6.1f %% %10.0f\n", row.name.c_str(), row.least, row.most,
                   100 * row.most / total, row.count);
}
} // namespace

namespace
{
char const* current_work = "";
}

char const* currentWork() { return current_work; }

NamedWork::NamedWork(char const* name) : before_(current_work) { current_work = name; }

NamedWork::~NamedWork() { current_work = before_; }

TimedWork::TimedWork(Teuchos::Time& timer)
    : timer_(timer)
    , named_(timer.name().c_str() + prefix.size())
{
  timer_.start();
}

RCP<Teuchos::Time> workTimer(std::string const& name)
{
  auto const existing = Teuchos::TimeMonitor::lookupCounter(prefix + name);
  return existing.is_null() ? Teuchos::TimeMonitor::getNewCounter(prefix + name) : existing;
}

double secondsSinceStart()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - program_start).count();
}

std::string tableOf(std::vector<WorkOfRanks> work, double total)
{
  std::stable_sort(work.begin(), work.end(),
                   [](WorkOfRanks const& a, WorkOfRanks const& b) { return a.most > b.most; });
  WorkOfRanks other{"other", total, total, 1};
  for (auto const& kind : work) {
    other.least -= kind.most;
    other.most -= kind.least;
  }
  other.least = std::max(other.least, 0.);
  other.most = std::max(other.most, 0.);
  std::string table =
    "Work                                min [s]    max [s]    share      count\n";
  for (auto const& kind : work) {
    table += line(kind, total);
  }
  return table + line(other, total) + line({"whole run", total, total, 1}, total);
}

std::string tableOfWork(Communicator const& communicator)
{
  const double total = maxOverRanks(secondsSinceStart(), communicator);
  return tableOf(workDone(communicator), total);
}
} // namespace asperity
