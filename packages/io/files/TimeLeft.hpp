#pragma once

#include "base/Archive.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace asperity::io
{
// The wall time that a run still needs. Between earthquakes a run may be a thousand times faster
// than in them, so that the speed of the last minutes does not predict the end. Once a whole cycle
// is known, from one event to the next, the rest of the run is taken to cost what past cycles did;
// of the cycle in which it ends, a part by the course of the last one. An event that follows
// another within a thousandth of the longest time without one is an aftershock and begins no cycle.
// Before a cycle is known, and in a last cycle that costs more than earlier ones, the estimate is
// from the speed of the last minutes, unless that is the speed of an event.
class TimeLeft
{
public:
  static constexpr double memory = 120;        // [s] of wall time, over which a speed is taken
  static constexpr std::size_t cycles = 10;    // the last ones, which the estimate looks at
  static constexpr std::size_t samples = 4000; // of the course of the run, at most
  static constexpr double aftershock = 1e-3;   // of the longest time between events
  static constexpr double event_speed = 1e-3;  // of the mean speed: slower runs are within an event

  struct Estimate
  {
    double seconds = 0;        // of wall time
    bool knows_cycles = false; // or is at the speed of the last minutes
  };

  // After every step: the simulated time [s], the wall time since any fixed moment [s], and how
  // many events have begun in the run.
  void note(double time, double wall, std::int64_t num_events = 0)
  {
    if (times_.empty()) {
      last_event_ = time; // the start counts as one
    } else if (num_events > num_events_) {
      noteEvent(time);
    }
    num_events_ = num_events;
    if (times_.size() > 1 && wall - walls_[walls_.size() - 2] < spacing_) {
      times_.pop_back();
      walls_.pop_back();
    }
    times_.push_back(time);
    walls_.push_back(wall);
    if (times_.size() > samples) {
      removeEveryOther(times_);
      removeEveryOther(walls_);
      spacing_ = 2 * (walls_.back() - walls_.front()) / samples;
    }
  }

  // Null as long as the speed is unknown, and during events before a whole cycle is known.
  std::optional<Estimate> estimate(double final_time) const
  {
    if (times_.size() < 2) {
      return {};
    }
    const bool knows_cycles = begins_.size() > 1;
    const double rest = std::max(0.0, final_time - times_.back());
    const double by_cycles = knows_cycles && rest > 0 ? secondsByCycles(final_time) : 0;
    if (by_cycles > 0) {
      return Estimate{by_cycles, true};
    }
    const double begin = std::max(walls_.back() - memory, walls_.front());
    const double done = times_.back() - interpolated(begin, walls_, times_);
    const double took = walls_.back() - begin;
    const double mean_speed = (times_.back() - times_.front()) / (walls_.back() - walls_.front());
    if (!(done > 0) || (!knows_cycles && done < event_speed * mean_speed * took)) {
      return {};
    }
    return Estimate{rest / done * took, knows_cycles};
  }

  void save(Archive& archive) const
  {
    archive.set("times", times_);
    archive.set("walls", walls_);
    archive.set("begins", begins_);
    archive.set("last_event", last_event_);
    archive.set("longest_quiet", longest_quiet_);
    archive.set("num_events", num_events_);
  }

  void restore(Archive const& archive)
  {
    times_ = archive.get<std::vector<double>>("times");
    walls_ = archive.get<std::vector<double>>("walls");
    begins_ = archive.get<std::vector<double>>("begins");
    last_event_ = archive.getDouble("last_event");
    longest_quiet_ = archive.getDouble("longest_quiet");
    num_events_ = archive.getInteger("num_events");
  }

private:
  void noteEvent(double onset)
  {
    const double quiet = onset - last_event_;
    if (quiet > aftershock * longest_quiet_) {
      begins_.push_back(onset);
      if (begins_.size() > cycles + 1) {
        begins_.erase(begins_.begin());
      }
    }
    longest_quiet_ = std::max(longest_quiet_, quiet);
    last_event_ = onset;
  }

  // The first and, of an odd number of values, the last one stay.
  static void removeEveryOther(std::vector<double>& values)
  {
    for (std::size_t i = 0; 2 * i < values.size(); ++i) {
      values[i] = values[2 * i];
    }
    values.resize((values.size() + 1) / 2);
  }

  // y at x, linear between points with ascending x, and constant beyond them.
  static double interpolated(double x, std::vector<double> const& xs, std::vector<double> const& ys)
  {
    const auto after = std::upper_bound(xs.begin(), xs.end(), x) - xs.begin();
    if (after == 0 || after == static_cast<std::ptrdiff_t>(xs.size())) {
      return after == 0 ? ys.front() : ys.back();
    }
    const double share = (x - xs[after - 1]) / (xs[after] - xs[after - 1]);
    return ys[after - 1] + share * (ys[after] - ys[after - 1]);
  }

  double wallAt(double time) const { return interpolated(time, times_, walls_); }

  // The rest of the current cycle, the whole cycles after it, and the part of the cycle in which
  // the run ends [s]. 0 in the last cycle if it has cost more than expected.
  double secondsByCycles(double final_time) const
  {
    const double first = begins_.front(), last = begins_.back(), before = *(begins_.end() - 2);
    const auto number = static_cast<double>(begins_.size() - 1);
    const double length = (last - first) / number, cost = (wallAt(last) - wallAt(first)) / number;
    // The part of a cycle's wall time that its first `share` of simulated time takes.
    const auto part = [&](double share) {
      const double begin = wallAt(before), whole = wallAt(last) - begin;
      return share < 1 && whole > 0 ? (wallAt(before + share * (last - before)) - begin) / whole
                                    : 1;
    };
    const double of_this = cost * part((final_time - last) / length);
    const double after = std::max(0.0, final_time - std::max(last + length, times_.back()));
    const double more = after / length; // cycles
    return std::max(0.0, of_this - (walls_.back() - wallAt(last))) +
           cost * (std::floor(more) + part(more - std::floor(more)));
  }

  std::vector<double> times_, walls_; // of steps, evenly spaced in wall time, and of the last one
  double spacing_ = 0;                // in wall time [s]
  std::vector<double> begins_;        // of the last cycles [s]: onsets of events
  double last_event_ = 0, longest_quiet_ = 0; // [s]
  std::int64_t num_events_ = 0;
};
} // namespace asperity::io
