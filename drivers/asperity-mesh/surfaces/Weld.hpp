#pragma once

#include "Warnings.hpp"
#include "surfaces/TriangleSurface.hpp"

#include <string>

namespace asperity::geometry
{
// The surface with equal points made one, without points that no triangle uses, without triangles
// that have no area (up to rounding) and without triangles that are there twice; `remark` gets a
// sentence on each kind of triangle that is dropped. InputError, which starts with `where`, if no
// triangle is left. Takes about 150 bytes a triangle in addition to the surface.
TriangleSurface welded(TriangleSurface&& surface, std::string const& where,
                       RemarkSink const& remark);
} // namespace asperity::geometry
