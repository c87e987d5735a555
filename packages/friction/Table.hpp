#pragma once

#include "friction/Types.hpp"

#include <vector>

namespace asperity::friction
{
// A function that is given at points and is a cubic between neighbours (Hermite interpolation):
// (num_points, 3), a row x, f, df/dx for each point, with increasing x, on the device.
using TableView = Kokkos::View<const double* [3], Kokkos::LayoutRight, MemorySpace>;

// The cubics through two points or more. They are monotone where the values f are (Fritsch and
// Carlson 1980), with an error of third order in the distance of the points. Throws
// std::invalid_argument if a number is not finite, x does not increase, or there are fewer than two
// points or not as many f as x.
TableView makeTable(std::vector<double> const& x, std::vector<double> const& f);

// A table as a law on the device sees it; a TableView keeps its memory. Host and device.
struct Table
{
  double const* points = nullptr;
  int num_points = 0;

  // f at x; beyond the points it is that of the first or the last one.
  KOKKOS_INLINE_FUNCTION double operator()(double x) const
  {
    int low = 0, high = num_points - 1;
    if (!(x > points[0])) {
      return points[1];
    }
    if (x >= points[3 * high]) {
      return points[3 * high + 1];
    }
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      (points[3 * middle] <= x ? low : high) = middle;
    }
    auto const* const p = points + 3 * low;
    const double h = p[3] - p[0], t = (x - p[0]) / h, rise = p[4] - p[1];
    const double bend = t * (1 - t); // the cubic is the chord and what the slopes add
    return p[1] + t * rise + bend * ((1 - t) * (h * p[2] - rise) - t * (h * p[5] - rise));
  }
};
} // namespace asperity::friction
