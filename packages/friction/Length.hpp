#pragma once

#include "friction/detail/Math.hpp"

namespace asperity::friction
{
// Euclidean length of a vector at a node without underflow or overflow, T = 1 or 2; not finite if a
// component is not. The square of a slip rate between earthquakes underflows. Host and device.
template <int T>
KOKKOS_INLINE_FUNCTION double length(double const (&vector)[T])
{
  const double x = math::fabs(vector[0]);
  if constexpr (T == 1) {
    return x;
  } else {
    const double y = math::fabs(vector[1]);
    const double longer = detail::larger(x, y);
    if (longer == 0 || !detail::isFinite(longer)) {
      return x + y; // it is 0 or not finite
    }
    const double ratio = detail::smaller(x, y) / longer;
    return longer * math::sqrt(1 + ratio * ratio);
  }
}
} // namespace asperity::friction
