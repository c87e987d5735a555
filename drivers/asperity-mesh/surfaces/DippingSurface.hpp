#pragma once

#include "surfaces/Lofting.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::geometry
{
// A surface below and above a trace. Azimuths are clockwise from y, the north. Someone who walks
// along the trace has the surface dip to the right; a dip over 90 degrees is one to the left.
struct DippingTrace
{
  Polyline trace;                      // [m]; at least two points
  std::vector<double> dips;            // one for each point [degrees], in (0, 180)
  std::optional<double> dip_direction; // azimuth [degrees] of all points instead of that rule
  double upper_z = 0, lower_z = 0;     // [m] of the upper and lower edge
  double spacing = 0;                  // [m] of points, at most; 0: a tenth of the width down dip
};

// From each point of the trace p the line p + (z_p - z) cot(dip) n, with z from upper_z to lower_z;
// between these lines the surface is ruled. n is the horizontal normal: at a bend it is lengthened
// so that the planes on both sides have the given dip. InputError, which starts with `path`, if the
// trace turns too sharply or the surface is folded.
TriangleSurface dippingSurface(DippingTrace const& given, std::string const& path);

// A rectangle. Its strike is along the azimuth [degrees], with the dip [degrees] to the right; the
// centre of its upper edge is given.
struct PlaneShape
{
  SpacePoint top_centre{}; // [m]
  double strike = 0, dip = 90;
  double length = 0, width = 0; // along strike and down dip [m]
};
TriangleSurface planeSurface(PlaneShape const& shape);

// The rectangle that goes on up dip to this z [m], if its upper edge lies deeper. InputError, which
// starts with `path`, for a horizontal one.
PlaneShape extendedUp(PlaneShape const& shape, double z, std::string const& path);
} // namespace asperity::geometry
