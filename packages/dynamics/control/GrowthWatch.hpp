#pragma once

#include "base/Warning.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace asperity::dynamics
{
// Warns of steps that hide a growing slip rate: earthquakes may be lost in them. The peak slip rate
// V at the end of such a step is more than twice that before it, and
// - V dt > L / 10 in a forced step, which does not meet the tolerance even at the smallest size, or
//   has a prescribed size. V is compared with the smallest rate in the present sequence of forced
//   steps, from the beginning of the first of them.
// - V dt > L in a step that meets the tolerance, which then is too loose.
// The two kinds are counted apart. So are steps that slip by more than 2 L where friction weakens
// and slip is slow (SlowSlip), in which a growth that is damped cannot show; they never end a run.
class GrowthWatch
{
public:
  // slip_distance: L [m], the smallest of the fault; 0 if unknown: then growth alone counts in
  // steps that do not meet the tolerance, and other steps are not judged.
  // most: the number of forced, or of other steps that hide growth at which the run ends; 0 means
  // no limit, which is always so for prescribed steps: all of them are forced.
  GrowthWatch(double slip_distance, std::int64_t most, bool is_prescribed = false)
      : slip_distance_(slip_distance)
      , most_(is_prescribed ? 0 : most)
      , is_prescribed_(is_prescribed)
  {
  }

  struct Step
  {
    bool is_forced = false;
    double time = 0;        // at its end [s]
    double step_size = 0;   // [s]
    double rate_before = 0; // peak slip rate [m/s]
    double rate = 0;        // the same at its end
    double slow_slip = 0;   // SlowSlip::of [-]
  };
  // Returns a warning for the 1st, 10th, 100th, ... step that hides growth, and for number `most`.
  std::optional<Warning> note(Step const& step);
  // Throws LostEarthquakes if `most` steps of one kind have hidden growth.
  void requireFew() const;

  // What a restart goes on from.
  struct Memory
  {
    double least = -1; // rate since forced steps began; negative after a step that is not forced
    std::int64_t forced = 0; // steps that hid growth
    std::int64_t others = 0;
    std::int64_t damped = 0; // steps that slipped by more than 2 L
  };
  Memory const& memory() const { return memory_; }
  void restore(Memory const& memory) { memory_ = memory; }

private:
  bool isForced(Step const& step) const { return step.is_forced || is_prescribed_; }
  bool hidesGrowth(Step const& step);
  std::string describe(Step const& step, std::int64_t count) const;
  std::optional<Warning> noteSlowSlip(Step const& step);

  double slip_distance_;
  std::int64_t most_;
  bool is_prescribed_;
  Memory memory_;
  std::string told_; // of the last step that hid growth, without a full stop
};
} // namespace asperity::dynamics
