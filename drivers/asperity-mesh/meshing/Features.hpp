#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"
#include "meshing/CellSize.hpp"

#include <utility>
#include <vector>

namespace asperity::geometry
{
// Places where a curve comes nearer to another curve or patch that it does not meet than the size
// of cells there, and that distance, at least `smallest_share` of that size: cells there have to be
// smaller to keep good angles.
std::vector<std::pair<Point<3>, double>> narrowPlaces(Complex const& complex, CellSize const& size,
                                                      double smallest_share);
} // namespace asperity::geometry
