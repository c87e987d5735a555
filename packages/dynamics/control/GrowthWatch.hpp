#pragma once

#include "fem/Warning.hpp"

#include <cstdint>
#include <optional>

namespace asperity::dynamics
{
// Notices forced steps that hide a slip rate which grows: earthquakes may be lost in them. A step
// is forced if even at the smallest size it does not meet the tolerance, or if its size is
// prescribed. It hides growth if at its end the peak slip rate V is above twice the least one since
// the forced steps in a row began (that before the first of them counts), and V dt > L / 10.
class GrowthWatch
{
public:
  // slip_distance: L [m], the smallest of the fault; 0 if unknown, and then growth alone counts.
  // most: steps that hide growth that are one too many; 0 means any number, as for prescribed ones,
  // of which all are forced.
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
  };
  // A warning for the first such step, the 10th, 100th and so on. Throws SolveError for one too
  // many.
  std::optional<Warning> note(Step const& step);

private:
  double slip_distance_;
  std::int64_t most_;
  bool is_prescribed_;
  double least_ = -1; // rate since forced steps began; negative where the last step was none
  std::int64_t count_ = 0;
};
} // namespace asperity::dynamics
