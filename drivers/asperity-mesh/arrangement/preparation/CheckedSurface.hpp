#pragma once

#include "arrangement/complex/Complex.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// A surface that can be arranged with others: points that are closer than 1e-9 of its extent are
// merged, all triangles have an area, and connected triangles have the same orientation.
//
// InputError, which starts with `where`, if it has no triangles; a coordinate is not finite; a
// triangle names a point that is not there, is given twice or has no area; more than two triangles
// meet at an edge; the surface cannot be oriented (a Moebius strip).
TriangleSurface checkedSurface(TriangleSurface const& surface, std::string const& where);

// The same for a surface that may branch: its sheets (sheetsOf), each checked.
std::vector<TriangleSurface> checkedSheets(TriangleSurface const& surface,
                                           std::string const& where);
} // namespace asperity::geometry
