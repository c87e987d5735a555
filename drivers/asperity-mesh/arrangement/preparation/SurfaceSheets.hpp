#pragma once

#include "arrangement/complex/Complex.hpp"

#include <vector>

namespace asperity::geometry
{
// The sheets of a surface that branches, largest first: where more than two of its parts meet at a
// line, those two go on as one sheet that bend least there on average, and so on with the rest.
// A surface that branches nowhere is one sheet, with all its parts.
std::vector<TriangleSurface> sheetsOf(TriangleSurface const& surface);
} // namespace asperity::geometry
