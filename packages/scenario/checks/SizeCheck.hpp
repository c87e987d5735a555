#pragma once

#include "base/Warning.hpp"
#include "scenario/problem/Problem.hpp"

#include <vector>

namespace asperity::scenario
{
// The numbers by which the size of a body is judged; lengths in m, times in s.
struct BodySize
{
  double extent = 0;        // of the diagonal of the bounding box
  double longest_axis = 0;  // of the bounding box
  double crossing_time = 0; // of a shear wave along the diagonal, at its lowest speed
  double cell_time = 0;     // of a shear wave along the longest edge of a cell, shortest
  bool has_waves = false;
  double smallest_step = 0; // 0 if the deck leaves it out
  double final_time = 0;
};

// Collective.
template <int Dim>
BodySize bodySize(Problem<Dim> const& problem);

// Warnings, on the topics "size of the body" and "size of cells", where the size of the body, its
// waves, steps and friction cannot belong together, as with a mesh in km that is read in m, or one
// in m that is read in km. `resolution` may be empty, where friction weakens nowhere.
std::vector<Warning> warnOfSize(BodySize const& size,
                                std::optional<dynamics::FaultResolution> const& resolution);

// A warning on the topic "prescribed slip" if the slip that the deck prescribes over the run is
// more than 5 % of the longest axis of its fault. Collective.
template <int Dim>
std::vector<Warning> warnOfPrescribedSlip(Problem<Dim> const& problem);
} // namespace asperity::scenario
