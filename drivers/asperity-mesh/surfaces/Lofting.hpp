#pragma once

#include "surfaces/TriangleSurface.hpp"

#include <array>
#include <vector>

namespace asperity::geometry
{
using SpacePoint = std::array<double, 3>;
using Polyline = std::vector<SpacePoint>;

double distanceOf(SpacePoint const& a, SpacePoint const& b);
SpacePoint between(SpacePoint const& a, SpacePoint const& b, double share); // a for 0, b for 1
double lengthOf(Polyline const& line);

// The polyline through `num_segments` + 1 points at equal arc lengths of a line; both ends stay.
Polyline resampled(Polyline const& line, int num_segments);

// The surface through rows of equally many points. The quadrilaterals between two rows are divided
// along the shorter diagonal.
TriangleSurface lofted(std::vector<Polyline> const& rows);

// The number of the first segment that goes against the same segment of another row, seen from
// above; -1 if none does. A surface through both rows would be folded there.
int foldedSegment(Polyline const& row, Polyline const& other);
} // namespace asperity::geometry
