#include "parameters/RangeText.hpp"

#include "base/Text.hpp"

namespace asperity
{
std::string textOf(Range const& range)
{
  return (range.hasLower() ? "[" : "(") + formatNumber(range.lower()) + ", " +
         formatNumber(range.upper()) + (range.hasUpper() ? "]" : ")");
}
} // namespace asperity
