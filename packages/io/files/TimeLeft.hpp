#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace asperity::io
{
// The wall time that a run still needs. Between earthquakes a run may be a thousand times faster
// than in them, so that the speed of the last minutes does not predict the end. Once this process
// has seen a whole cycle, from one event to the next, the rest of the run is taken to cost what
// past cycles did. An event that follows another within a thousandth of the longest time without
// one is an aftershock and begins no cycle. Before a cycle is known, and where there are no
// events, the estimate is from the recent speed: an average over wall time in which the speed of
// `memory` seconds ago has the weight 1/e.
//
// python/asperity/estimate.py does the same with what a run leaves on disk.
class TimeLeft
{
public:
  static constexpr double memory = 120;        // [s]
  static constexpr std::size_t cycles = 10;    // the last ones, which the estimate looks at
  static constexpr std::size_t samples = 2000; // of a cycle, at most
  static constexpr double aftershock = 1e-3;   // of the longest time between events

  // fraction: the part of the simulated time that is done. seconds: wall time since any fixed
  // moment. num_events: that have begun so far, in the whole run.
  void note(double fraction, double seconds, std::int64_t num_events = 0)
  {
    const Moment now{fraction, seconds};
    if (has_begun_) {
      const double elapsed = seconds - now_.seconds;
      const double decay = std::exp(-elapsed / memory);
      done_ = decay * done_ + (fraction - now_.fraction);
      spent_ = decay * spent_ + elapsed;
      if (num_events > num_events_) {
        noteEvent(now);
      }
      sample(now);
    } else {
      last_event_ = fraction;
    }
    now_ = now;
    num_events_ = num_events;
    has_begun_ = true;
  }

  // Whether the estimate is from past cycles.
  bool knowsCycles() const { return onsets_.size() > 1; }

  // The time left [s]; negative as long as the speed is unknown. In the last cycle of the run, once
  // it costs more than earlier ones, the estimate is from the recent speed.
  double seconds() const
  {
    if (now_.fraction >= 1) {
      return 0;
    }
    const double of_cycles = knowsCycles() ? ofCycles() : 0;
    if (of_cycles > 0) {
      return of_cycles;
    }
    return done_ > 0 ? (1 - now_.fraction) * spent_ / done_ : -1;
  }

private:
  struct Moment
  {
    double fraction = 0, seconds = 0;
  };

  void noteEvent(Moment const& onset)
  {
    const double quiet = onset.fraction - last_event_;
    if (onsets_.empty() || quiet > aftershock * longest_quiet_) {
      beginCycle(onset);
    }
    longest_quiet_ = std::max(longest_quiet_, quiet);
    last_event_ = onset.fraction;
  }

  void beginCycle(Moment const& onset)
  {
    onsets_.push_back(onset);
    if (onsets_.size() > cycles + 1) {
      onsets_.pop_front();
    }
    last_cycle_ = std::move(this_cycle_);
    last_cycle_.push_back(onset);
    this_cycle_.clear();
    spacing_ = 0;
  }

  // Removes every other sample when there are more than `samples`. They stay evenly spaced in wall
  // time.
  void sample(Moment const& now)
  {
    if (this_cycle_.empty() || now.seconds - this_cycle_.back().seconds >= spacing_) {
      this_cycle_.push_back(now);
    }
    if (this_cycle_.size() > samples) {
      for (std::size_t i = 0; 2 * i < this_cycle_.size(); ++i) {
        this_cycle_[i] = this_cycle_[2 * i];
      }
      this_cycle_.resize((this_cycle_.size() + 1) / 2);
      spacing_ = 2 * (this_cycle_.back().seconds - this_cycle_.front().seconds) / samples;
    }
  }

  // The part of a cycle's wall time that its first `share` of simulated time took, by the last one.
  double wallShare(double share) const
  {
    auto const &begin = last_cycle_.front(), &end = last_cycle_.back();
    const double fraction = begin.fraction + share * (end.fraction - begin.fraction);
    const auto after =
      std::upper_bound(last_cycle_.begin(), last_cycle_.end(), fraction,
                       [](double value, Moment const& at) { return value < at.fraction; });
    if (share <= 0) {
      return 0;
    }
    if (share >= 1 || after == last_cycle_.end() || !(end.seconds > begin.seconds)) {
      return 1;
    }
    return (after->seconds - begin.seconds) / (end.seconds - begin.seconds);
  }

  // The rest of the current cycle, the whole cycles after it, and the part of the cycle in which
  // the run ends [s]. 0 in the last cycle if it has cost more than expected.
  double ofCycles() const
  {
    auto const &first = onsets_.front(), &last = onsets_.back();
    const auto number = static_cast<double>(onsets_.size() - 1);
    const double fraction = (last.fraction - first.fraction) / number;
    const double seconds = (last.seconds - first.seconds) / number;
    if (!(fraction > 0)) {
      return 0;
    }
    const double part = seconds * wallShare((1 - last.fraction) / fraction);
    const double of_this = std::max(0.0, part - (now_.seconds - last.seconds));
    const double after = 1 - std::max(last.fraction + fraction, now_.fraction);
    const double more = std::max(0.0, after) / fraction; // cycles
    return of_this + seconds * (std::floor(more) + wallShare(more - std::floor(more)));
  }

  bool has_begun_ = false;
  Moment now_;
  double done_ = 0, spent_ = 0; // recently
  std::int64_t num_events_ = 0;
  double last_event_ = 0, longest_quiet_ = 0; // parts of the simulated time; the start is an event
  std::deque<Moment> onsets_;                 // of the last events
  std::vector<Moment> last_cycle_, this_cycle_;
  double spacing_ = 0; // of samples [s]
};
} // namespace asperity::io
