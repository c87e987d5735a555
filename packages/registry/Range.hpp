#pragma once

#include <limits>

namespace asperity
{
inline constexpr double infinity = std::numeric_limits<double>::infinity();

// The values a number may take. An infinite end is always open; NaN is in no range, not even in
// any(). It is constant at compile time, as tables of the parameters of laws are.
class Range
{
public:
  // has_lower, has_upper: whether the bound itself belongs to the range.
  constexpr Range(double lower, bool has_lower, double upper, bool has_upper)
      : lower_(lower)
      , upper_(upper)
      , has_lower_(has_lower && isFinite(lower))
      , has_upper_(has_upper && isFinite(upper))
  {
  }

  static constexpr Range any() { return Range(-infinity, false, infinity, false); }
  static constexpr Range positive() { return above(0); }
  static constexpr Range atLeast(double lower) { return Range(lower, true, infinity, false); }
  static constexpr Range above(double lower) { return Range(lower, false, infinity, false); }
  static constexpr Range below(double upper) { return Range(-infinity, false, upper, false); }
  static constexpr Range closed(double lower, double upper)
  {
    return Range(lower, true, upper, true);
  }
  static constexpr Range open(double lower, double upper)
  {
    return Range(lower, false, upper, false);
  }
  static constexpr Range openClosed(double lower, double upper)
  {
    return Range(lower, false, upper, true);
  }
  static constexpr Range closedOpen(double lower, double upper)
  {
    return Range(lower, true, upper, false);
  }

  constexpr double lower() const { return lower_; }
  constexpr double upper() const { return upper_; }
  constexpr bool hasLower() const { return has_lower_; }
  constexpr bool hasUpper() const { return has_upper_; }

  constexpr bool contains(double value) const
  {
    const bool above = has_lower_ ? value >= lower_ : value > lower_;
    const bool below = has_upper_ ? value <= upper_ : value < upper_;
    return above && below;
  }

  constexpr bool isEmpty() const
  {
    return lower_ > upper_ || (lower_ == upper_ && !(has_lower_ && has_upper_));
  }

  constexpr Range intersection(Range const& other) const
  {
    Range result = *this;
    if (other.lower_ > lower_ || (other.lower_ == lower_ && !other.has_lower_)) {
      result.lower_ = other.lower_;
      result.has_lower_ = other.has_lower_;
    }
    if (other.upper_ < upper_ || (other.upper_ == upper_ && !other.has_upper_)) {
      result.upper_ = other.upper_;
      result.has_upper_ = other.has_upper_;
    }
    return result;
  }

private:
  static constexpr bool isFinite(double value) { return value > -infinity && value < infinity; }

  double lower_, upper_;
  bool has_lower_, has_upper_;
};
} // namespace asperity
