#pragma once

#include <cmath>

namespace asperity::io
{
// The wall time that a run still needs, judged by its recent speed: an average over wall time in
// which what happened `memory` seconds ago has the weight 1/e. A mean since the start would promise
// half a minute all through an earthquake of ten.
class TimeLeft
{
public:
  static constexpr double memory = 120; // [s]

  // fraction: of the simulated time that is done. seconds: wall time since any fixed moment.
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

  // [s]; negative as long as there is nothing to judge by.
  double seconds() const { return done_ > 0 ? (1 - last_fraction_) * spent_ / done_ : -1; }

private:
  bool has_begun_ = false;
  double last_fraction_ = 0, last_seconds_ = 0;
  double done_ = 0, spent_ = 0; // recently
};
} // namespace asperity::io
