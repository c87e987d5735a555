#pragma once

#include "arrangement/complex/Complex.hpp"

namespace asperity::geometry
{
// Rounding makes edges without length and triangles without height, also where surfaces touch up to
// rounding. Merges the ends of edges that are shorter than `tolerance` [m], and divides all
// triangles at an edge whose opposite corner in one of them is closer than that. `tolerance` has to
// be far smaller than all details of the input.
void removeRounding(Complex& complex, double tolerance);
} // namespace asperity::geometry
