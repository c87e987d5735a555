#pragma once

#include "arrangement/complex/Complex.hpp"

#include <vector>

namespace asperity::geometry
{
constexpr double sharp_turn = 0.5; // cosine of the change of direction from which on a curve ends

// A line along which the same surfaces meet, or along which a surface ends.
struct Curve
{
  std::vector<int> points;   // from end to end; first and last are equal if the curve is closed
  std::vector<int> surfaces; // ascending, one entry for each triangle at it
};

// The edges that do not lie between two triangles of one surface, as curves, which end where others
// meet them, their surfaces change, or they turn by more than 60 degrees.
std::vector<Curve> findCurves(Complex const& complex);

double lengthOf(Complex const& complex, Curve const& curve); // [m]
} // namespace asperity::geometry
