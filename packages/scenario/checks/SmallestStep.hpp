#pragma once

#include "scenario/checks/Description.hpp"
#include "scenario/problem/Problem.hpp"

namespace asperity::scenario
{
// `Time Stepping / Smallest Step` [s]; where the deck leaves it out, dynamics::seismicStep, or half
// of the largest step if that is smaller. Where no state of the fault decides on steps it is a
// millionth of the run, and with inertia at most a tenth of what a shear wave takes through the
// smallest cell.
// Throws InputError where a default is needed and friction weakens nowhere that can slip, and where
// rock relaxes in less than a thousandth of the step.
template <int Dim>
double smallestStep(Problem<Dim> const& problem);

// A line about the default, where it is used, or a warning where the step of the deck is longer
// than an earthquake takes to slip by L.
template <int Dim>
void describeSmallestStep(Problem<Dim> const& problem, Description& description);
} // namespace asperity::scenario
