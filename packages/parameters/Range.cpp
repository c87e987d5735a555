#include "parameters/Range.hpp"

#include "base/Text.hpp"

namespace asperity
{
bool Range::contains(double value) const
{
  const bool above = has_lower_ ? value >= lower_ : value > lower_;
  const bool below = has_upper_ ? value <= upper_ : value < upper_;
  return above && below;
}

bool Range::isEmpty() const
{
  return lower_ > upper_ || (lower_ == upper_ && !(has_lower_ && has_upper_));
}

Range Range::intersection(Range const& other) const
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

std::string Range::text() const
{
  return (has_lower_ ? "[" : "(") + formatNumber(lower_) + ", " + formatNumber(upper_) +
         (has_upper_ ? "]" : ")");
}
} // namespace asperity
