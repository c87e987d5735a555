#pragma once

#include "io/OutputDomain.hpp"

#include <array>
#include <optional>

namespace asperity::catalogue
{
// How a fault that is a curve lies in the x-y plane, by its ends. Its positions count from the
// upper end, down dip; along +x where the fault is level.
struct FaultAxis
{
  std::array<double, 2> upper{}, lower{}; // [m] where positions are least and largest
  double length = 0;                      // [m] largest position
  bool is_level = false;                  // the plane is a map, and the fault runs along strike
  bool tangent_rises = false;             // the direction in which slip is positive has a part up
};

// Collective.
FaultAxis faultAxis(io::OutputDomain const& fault);

// The point of a fault that is a curve at a position [m]; nothing if it is not as long. The same on
// all ranks. Collective.
std::optional<std::array<double, 2>> pointAlong(io::OutputDomain const& fault, double distance);
} // namespace asperity::catalogue
