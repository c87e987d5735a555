#pragma once

#include "formats/VtkGrid.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// The grid of all pieces, as programs write them that run on several processors. Points of several
// pieces at exactly one place become one, so that the body is whole; a WARNING if there are none.
// Cells that a piece repeats from another one (vtkGhostType) are left out. Cell data are kept if
// all pieces have them. A single piece stays as it is.
//
// InputError, which starts with `where`, for counts that do not fit, and if a piece has several
// points where another piece has one: which of them is meant is unknown.
VtkGrid joined(std::vector<VtkGrid> pieces, std::string const& where);
} // namespace asperity::geometry
