#pragma once

#include "arrangement/complex/Complex.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// A surface that can be arranged with others: points that are equal up to 1e-9 of its extent are
// one, all triangles have an area, and their normals point to one side wherever they are connected.
//
// InputError, which starts with `where`, if it has no triangles; a coordinate is not finite; a
// triangle names a point that is not there, is given twice or has no area; more than two triangles
// meet at an edge; the surface has only one side (a Moebius strip).
TriangleSurface checkedSurface(TriangleSurface const& surface, std::string const& where);

// The same for a surface that may branch: its sheets (sheetsOf), each checked.
std::vector<TriangleSurface> checkedSheets(TriangleSurface const& surface,
                                           std::string const& where);
} // namespace asperity::geometry
