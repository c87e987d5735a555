#pragma once

#include "arrangement/complex/Complex.hpp"

#include <vector>

namespace asperity::geometry
{
constexpr double sharp_turn = 0.5; // cosine of the turn of a curve that makes a corner

// A line along which surfaces meet, or a surface ends. It has the same surfaces all along.
struct Curve
{
  std::vector<int> points;   // of the complex, from corner to corner; the same one if it is closed
  std::vector<int> surfaces; // ascending, one entry for each triangle at it
};

// The edges that do not lie between two triangles of one surface, as curves, which end where others
// meet them, their surfaces change, or they turn by more than 60 degrees.
std::vector<Curve> findCurves(Complex const& complex);

double lengthOf(Complex const& complex, Curve const& curve); // [m]
} // namespace asperity::geometry
