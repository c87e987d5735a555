#include "dynamics/watches/RingWatch.hpp"

#include "base/Text.hpp"

#include <string>

namespace asperity::dynamics
{
namespace
{
// The factor by which the rate has to change. With this factor and 10 steps, the two kinds of run
// are far apart: decks without ringing turn at most 2 times in a row, spring_slider.xml with
// Newmark and tolerances from 1e-2 to 1e-5 more than 1000 times.
constexpr double turn = 1.5;
} // namespace

void RingWatch::note(WatchedState const& now, Notes& notes)
{
  if (now.step && fault_ != nullptr && fault_->stateDecides()) {
    notes.add(note(now.time, now.sample.peakSlipRate()));
  }
}

std::optional<Warning> RingWatch::note(double time, double rate)
{
  const bool is_first = rate_ < 0;
  const int direction = is_first ? 0 : rate > turn * rate_ ? 1 : turn * rate < rate_ ? -1 : 0;
  turns_ = direction == 0 ? 0 : direction == -direction_ ? turns_ + 1 : 1;
  rate_ = rate;
  direction_ = direction;
  if (turns_ < next_warning_) {
    return std::nullopt;
  }
  next_warning_ *= 10;
  return Warning{"ringing",
                 "The slip rate rings: in " + std::to_string(turns_) +
                   " steps in a row, the last one to t = " + formatShort(time) +
                   " s, its peak went up and down by more than a factor of " + formatShort(turn) +
                   ". An event may count several times, and cycles may be too short. Choose Scheme "
                   "= Generalised Alpha, which damps this, or a much smaller 'Tolerance'."};
}
} // namespace asperity::dynamics

ASPERITY_REGISTER(asperity::dynamics::WatchRegistry, "ring_watch",
                  asperity::dynamics::WatchKindOf<asperity::dynamics::RingWatch>)
