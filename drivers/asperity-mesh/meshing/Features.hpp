#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"
#include "meshing/CellSize.hpp"

#include <utility>
#include <vector>

namespace asperity::geometry
{
// Places where the distance of a curve to another curve or patch, which it does not meet, is below
// the size of cells, each with that distance, or with `smallest_share` of the size if that is
// larger. Larger cells would have small angles there.
std::vector<std::pair<Point<3>, double>> narrowPlaces(Complex const& complex, CellSize const& size,
                                                      double smallest_share);
} // namespace asperity::geometry
