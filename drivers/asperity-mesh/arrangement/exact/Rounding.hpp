#pragma once

#include "arrangement/complex/Complex.hpp"

namespace asperity::geometry
{
// After rounding, or where surfaces touch up to rounding, edges may have no length and triangles no
// height. Makes points one that an edge shorter than `tolerance` [m] joins, and divides all
// triangles at an edge to which a corner of one of them is that near. `tolerance` has to be far
// smaller than all that is meant.
void removeRounding(Complex& complex, double tolerance);
} // namespace asperity::geometry
