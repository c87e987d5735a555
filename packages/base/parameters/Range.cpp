#include "base/parameters/Range.hpp"

#include "base/Text.hpp"

namespace asperity
{
bool Range::contains(double value) const
{
  const bool above = has_lower_ ? value >= lower_ : value > lower_;
  const bool below = has_upper_ ? value <= upper_ : value < upper_;
  return above && below;
}

std::string Range::text() const
{
  return (has_lower_ ? "[" : "(") + formatNumber(lower_) + ", " + formatNumber(upper_) +
         (has_upper_ ? "]" : ")");
}
} // namespace asperity
