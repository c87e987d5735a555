#pragma once

#include "mesh/Mesh.hpp"

#include <array>

namespace asperity::geometry
{
// The smallest of the six angles between faces of a cell [degrees].
double smallestDihedral(std::array<Point<3>, 4> const& corners);
// The same, negative if the orientation of the cell is reversed.
double orientedAngle(std::array<Point<3>, 4> const& corners);
} // namespace asperity::geometry
