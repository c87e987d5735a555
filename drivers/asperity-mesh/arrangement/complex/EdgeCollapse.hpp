#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"

#include <functional>

namespace asperity::geometry
{
// Lengths [m] below which an edge at a place is contracted.
using Shortest = std::function<double(Point<3> const&)>;

// Contracts edges that are shorter than `shortest`, so that no curve and no triangle is much
// smaller than the cells that are to be made there. A point inside a patch may move onto any
// neighbour, a point of a curve along the curve, and a corner, where curves meet, onto another
// corner, unless two curves would then enclose a small angle. Points of the ground, of walls and of
// the bottom stay on them, no triangle reverses its normal, and the topology of surfaces is kept.
// Returns how many corners were moved onto others.
int contractShortEdges(Complex& complex, Model const& model, Shortest const& shortest);
} // namespace asperity::geometry
