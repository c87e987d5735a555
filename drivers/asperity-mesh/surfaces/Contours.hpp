#pragma once

#include "Warnings.hpp"
#include "surfaces/Lofting.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::geometry
{
// Depth contours as slab models have them, in the file's own units: lines "x y z", or "x y" below a
// line with the depth alone. A contour ends at an empty line, at a line of other words (END, >), or
// where z changes. Depths may be positive or negative; z of the result is negative below zero.
// InputError with file and line.
std::vector<Polyline> readContours(std::string const& file_name);

struct ContourOptions
{
  std::optional<double> lower_z; // [m]: the surface ends there, between two contours if need be
  std::optional<double> upper_z; // [m]: it goes on up dip to there
  double spacing = 0;            // [m] of points along strike; 0: that of the contours
};

// The surface through contours [m] that come in any order and direction: pieces of one depth are
// joined at their nearest ends, contours are sorted by depth and turned into one direction, and
// points at equal shares of their lengths are connected. InputError, which starts with `where`, for
// fewer than two depths, closed contours, a lower edge outside the contours, or a folded surface.
TriangleSurface contourSurface(std::vector<Polyline> contours, ContourOptions const& options,
                               std::string const& where, RemarkSink const& remark = warn);
} // namespace asperity::geometry
