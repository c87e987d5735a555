#pragma once

#include "Warnings.hpp"
#include "surfaces/TriangleSurface.hpp"

#include <string>

namespace asperity::geometry
{
// Merges equal points, and removes points without a triangle, triangles without an area (up to
// rounding) and copies of triangles. `remark` gets a sentence on each kind of triangle that is
// removed. InputError, which starts with `where`, if no
// triangle is left. Takes about 150 bytes a triangle in addition to the surface.
TriangleSurface welded(TriangleSurface&& surface, std::string const& where,
                       RemarkSink const& remark);
} // namespace asperity::geometry
