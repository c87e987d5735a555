#pragma once

#include <cmath>

namespace asperity::io
{
// The wall time that a run still needs, estimated from its recent speed: an average over wall time
// in which the speed of `memory` seconds ago has the weight 1/e. With a mean since the start, the
// estimate would stay at half a minute all through an earthquake that takes ten minutes.
class TimeLeft
{
public:
  static constexpr double memory = 120; // [s]

  // fraction: the part of the simulated time that is done. seconds: wall time since any fixed
  // moment.
  void note(double fraction, double seconds)
  {
    if (has_begun_) {
      const double elapsed = seconds - last_seconds_;
      const double decay = std::exp(-elapsed / memory);
      done_ = decay * done_ + (fraction - last_fraction_);
      spent_ = decay * spent_ + elapsed;
    }
    has_begun_ = true;
    last_fraction_ = fraction;
    last_seconds_ = seconds;
  }

  // The time left [s]; negative as long as the speed is unknown.
  double seconds() const { return done_ > 0 ? (1 - last_fraction_) * spent_ / done_ : -1; }

private:
  bool has_begun_ = false;
  double last_fraction_ = 0, last_seconds_ = 0;
  double done_ = 0, spent_ = 0; // recently
};
} // namespace asperity::io
