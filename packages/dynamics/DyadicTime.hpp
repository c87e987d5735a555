#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>

namespace asperity::dynamics
{
// Time as a count of ticks, so that centuries and milliseconds add without loss: step sizes are
// largest_step 2^-level, 0 <= level <= finest_level, and one tick is the smallest step.
class DyadicTime
{
public:
  using Ticks = std::int64_t;

  // largest_step in s; finest_level <= 60.
  DyadicTime(double largest_step, int finest_level)
      : largest_step_(largest_step)
      , finest_level_(finest_level)
  {
  }

  int finestLevel() const { return finest_level_; }
  Ticks ticks(int level) const { return Ticks(1) << (finest_level_ - level); }
  double stepSize(int level) const { return std::ldexp(largest_step_, -level); }
  double seconds(Ticks ticks) const
  {
    // The product of a whole number below 2^53 and a power of two times largest_step is rounded
    // once.
    return std::ldexp(static_cast<double>(ticks), -finest_level_) * largest_step_;
  }
  // The level of the largest step that has at most `count` ticks; count >= 1.
  int levelWithin(Ticks count) const
  {
    int level = 0;
    while (ticks(level) > count) {
      ++level;
    }
    return level;
  }
  // The smallest count of ticks that reaches a time, up to rounding: 1.1 s / 0.1 s is a bit above
  // 11.
  Ticks reaching(double seconds) const
  {
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    const double count = std::ldexp(seconds / largest_step_, finest_level_);
    return static_cast<Ticks>(std::ceil(count * (1 - rounding)));
  }
  // Converts ticks of a clock with the same largest step and another finest level; empty if they
  // are not a whole number of ticks here.
  std::optional<Ticks> fromLevel(Ticks count, int finest_level) const
  {
    const Ticks factor = Ticks(1) << std::abs(finest_level_ - finest_level);
    if (finest_level_ >= finest_level) {
      return count * factor;
    }
    return count % factor == 0 ? std::optional<Ticks>(count / factor) : std::nullopt;
  }
  // Whether a count of ticks can be as large as this time.
  bool reaches(double seconds) const
  {
    return std::ldexp(seconds / largest_step_, finest_level_) < 9.0e18;
  }

private:
  double largest_step_;
  int finest_level_;
};
} // namespace asperity::dynamics
