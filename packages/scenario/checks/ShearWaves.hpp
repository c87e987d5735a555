#pragma once

#include "scenario/problem/Problem.hpp"

namespace asperity::scenario
{
// The times of shear waves in the rock of a body.
struct ShearWaves
{
  double through_cell = 0; // along the longest edge of a cell, the shortest of these times [s]
  double slowness = 0;     // the largest, 1 / c_s [s/m]
};

// Collective.
template <int Dim>
ShearWaves shearWavesOf(Problem<Dim> const& problem);
} // namespace asperity::scenario
