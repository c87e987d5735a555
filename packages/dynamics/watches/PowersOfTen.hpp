#pragma once

#include <cstdint>

namespace asperity::dynamics
{
// Whether a count above zero is 1, 10, 100, ...: a watch that warns at these keeps the log short.
inline bool isPowerOfTen(std::int64_t count)
{
  while (count > 1 && count % 10 == 0) {
    count /= 10;
  }
  return count == 1;
}
} // namespace asperity::dynamics
