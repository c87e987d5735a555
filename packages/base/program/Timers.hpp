#pragma once

#include "base/Text.hpp"

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
// Wall time spent in one kind of work, and how often.
class Timer
{
public:
  using Clock = std::chrono::steady_clock;

  void add(Clock::duration elapsed)
  {
    elapsed_ += elapsed;
    ++count_;
  }
  double seconds() const { return std::chrono::duration<double>(elapsed_).count(); }
  long long count() const { return count_; }

private:
  Clock::duration elapsed_{0};
  long long count_ = 0;
};

// Times the block it lives in, at the price of reading the clock twice.
class TimedScope
{
public:
  explicit TimedScope(Timer& timer) : timer_(timer), start_(Timer::Clock::now()) {}
  ~TimedScope() { timer_.add(Timer::Clock::now() - start_); }
  TimedScope(TimedScope const&) = delete;
  TimedScope& operator=(TimedScope const&) = delete;

private:
  Timer& timer_;
  Timer::Clock::time_point start_;
};

// Timers by name. Keep the reference where a scope is entered often; finding a name costs more than
// timing:
//   Timer& assembly = Timers::global()["assembly"];
//   { TimedScope scope(assembly); ... }
// One host thread.
class Timers
{
public:
  static Timers& global()
  {
    static Timers timers;
    return timers;
  }

  // Makes the timer on first use; the reference stays valid as long as this object.
  Timer& operator[](std::string const& name) { return timers_[name]; }

  // One line per timer that ran, the longest first: name, seconds, calls, time per call. This
  // rank's times.
  void print(std::ostream& out) const;

private:
  std::map<std::string, Timer> timers_;
};

inline void Timers::print(std::ostream& out) const
{
  std::vector<std::pair<std::string, Timer>> rows;
  std::size_t width = 4;
  for (auto const& row : timers_) {
    if (row.second.count() > 0) {
      rows.push_back(row);
      width = std::max(width, row.first.size());
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](auto const& left, auto const& right) {
    return left.second.seconds() > right.second.seconds();
  });
  const auto line = [&](std::string const& name, std::string const& time, std::string const& calls,
                        std::string const& each) {
    out << std::left << std::setw(static_cast<int>(width)) << name << std::right << std::setw(14)
        << time << std::setw(14) << calls << std::setw(14) << each << '\n';
  };
  line("Work", "time", "calls", "per call");
  for (auto const& [name, timer] : rows) {
    const auto calls = static_cast<double>(timer.count());
    line(name, formatDuration(timer.seconds()), std::to_string(timer.count()),
         formatDuration(timer.seconds() / calls));
  }
}
} // namespace asperity
