#pragma once

#include "base/Types.hpp"

#include <array>
#include <map>
#include <vector>

namespace asperity::io::detail
{
// A boundary segment of a plane mesh, by the global ids of its ends.
using Segment = std::array<GlobalOrdinal, 2>;
using PlanePoint = std::array<double, 2>;

struct CurveOrder
{
  std::vector<GlobalOrdinal> vertex_ids; // along the curve
  std::vector<double> positions;         // arc length [m] of each
};

// Walks along the segments, from the end with the smaller coordinates (x, then y). Pieces follow
// each other by the coordinates of their first vertex, each continuing where the one before it
// ended; closed curves begin at their least vertex. InputError if the curve branches.
CurveOrder orderCurve(std::vector<Segment> const& segments,
                      std::map<GlobalOrdinal, PlanePoint> const& coordinates);
} // namespace asperity::io::detail
