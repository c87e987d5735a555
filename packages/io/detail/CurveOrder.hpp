#pragma once

#include "base/Types.hpp"
#include "io/OutputDomain.hpp"

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

// Walks along the segments from the end that `start` names. Pieces come in the order of their first
// vertices, closed curves last, and positions continue from one piece to the next. A closed curve
// begins at the vertex that would be the first of all ends. Throws InputError if the curve
// branches.
CurveOrder orderCurve(std::vector<Segment> const& segments,
                      std::map<GlobalOrdinal, PlanePoint> const& coordinates, CurveStart start);
} // namespace asperity::io::detail
