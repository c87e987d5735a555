#pragma once

#include "arrangement/complex/Box.hpp"

#include <vector>

namespace asperity::geometry
{
// Moves the border of faults that ends nearer than `snap` [m] to another surface across that
// surface, by three times as much and along its own plane, unless it would end on the same side or
// fold its surface. Borders that touch it only up to rounding, or stop a little short, then meet
// it. What lies beyond it is dropped after the arrangement
// (keepBody). Returns (num_surfaces) x (its points): whether the point was moved.
std::vector<std::vector<bool>> pushBorders(Model& model, double snap);
} // namespace asperity::geometry
