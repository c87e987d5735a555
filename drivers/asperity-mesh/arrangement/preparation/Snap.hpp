#pragma once

#include "arrangement/complex/Box.hpp"

#include <vector>

namespace asperity::geometry
{
// Extends faults whose border is nearer than `snap` [m] to another surface, so that they intersect
// it: border points move across that surface by 3 snap, in the plane of the fault. Points stay
// where they would not reach the other side, or would fold the fault. The part of a fault beyond
// the other surface is removed after the arrangement (keepBody). Returns for each surface whether
// each of its points was moved.
std::vector<std::vector<bool>> pushBorders(Model& model, double snap);
} // namespace asperity::geometry
