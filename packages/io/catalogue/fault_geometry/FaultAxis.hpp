#pragma once

#include "io/Location.hpp"

#include <vector>

namespace asperity::io::detail
{
// How a platform names the places on a fault that is a curve in the x-y plane.
struct FaultAxis
{
  // Of the fault's nodes on rank 0, by number: the distance along the fault from the end with the
  // larger y, which is down dip; along +x where the fault is level.
  std::vector<double> distances;
  bool is_level = false; // the plane is a map, and the fault runs along strike
};

// Collective.
FaultAxis faultAxis(Location const& fault);
} // namespace asperity::io::detail
