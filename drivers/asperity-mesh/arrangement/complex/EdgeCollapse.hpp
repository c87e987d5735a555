#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"

#include <functional>

namespace asperity::geometry
{
// Lengths [m] below which an edge at a place is contracted.
using Shortest = std::function<double(Point<3> const&)>;

// Contracts edges that are shorter than `shortest`, so that no curve between two surfaces, and no
// triangle, is much smaller than the cells that are to be made there. An end inside a patch moves
// to the other end; one on a curve moves along the curve; a corner, where curves meet, moves only
// onto a corner, unless that makes a narrow wedge of two curves. No point leaves the ground, a wall
// or the bottom; no triangle turns over; no two parts of a surface are joined that were apart.
// Returns how many corners were moved onto others.
int contractShortEdges(Complex& complex, Model const& model, Shortest const& shortest);
} // namespace asperity::geometry
