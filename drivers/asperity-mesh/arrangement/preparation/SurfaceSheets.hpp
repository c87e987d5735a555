#pragma once

#include "arrangement/complex/Complex.hpp"

#include <vector>

namespace asperity::geometry
{
// The sheets of a surface that branches, largest first. Where more than two parts of the surface
// meet along a line, the two parts with the smallest mean angle between them are joined to one
// sheet, then the next two, and so on. A surface that branches nowhere is one sheet, even if it is
// not connected.
std::vector<TriangleSurface> sheetsOf(TriangleSurface const& surface);
} // namespace asperity::geometry
