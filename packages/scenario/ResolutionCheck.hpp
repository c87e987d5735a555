#pragma once

#include "dynamics/FaultResolution.hpp"
#include "scenario/Problem.hpp"
#include "scenario/RunReport.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// How well the mesh resolves ruptures, with the initial normal stress. Empty if friction weakens
// nowhere, or if the laws do not say what a, b and L are. Collective.
template <int Dim>
std::optional<dynamics::FaultResolution> faultResolution(Problem<Dim> const& problem,
                                                         ParameterList const& friction);

// Lines about size: cells, vertices and unknowns, the true diameters of cells, the memory that the
// model takes as built and what is known of the solver's, and what a step will cost, from the
// product of the stiffness matrix with a vector, timed here. Collective.
template <int Dim>
std::vector<std::string> describeSize(Problem<Dim> const& problem);

// Lines for the log. The nucleation length is known for the ageing law; of other laws the lines
// have the shortest wavelength that grows. mesh_type: `Mesh / Type`.
std::vector<std::string> describe(dynamics::FaultResolution const& resolution,
                                  std::string const& state_law, std::string const& mesh_type);
// Of fewer than three cells per cohesive zone, and of a part that weakens, beside others that do
// not, which is less than half as long as the nucleation length.
std::vector<Warning> warnOfResolution(dynamics::FaultResolution const& resolution,
                                      std::string const& state_law);

// `Time Stepping / Smallest Step` [s]; where the deck leaves it out, a hundredth of L over a
// seismic slip rate (dynamics::FaultResolution), and with inertia at most a tenth of the time that
// a shear wave takes through a cell at the fault; such that ticks can count to the end of the run.
// Throws InputError where a default is needed and friction weakens nowhere. Collective.
template <int Dim>
double smallestStep(Problem<Dim> const& problem, ParameterList const& deck);

// A line about the default, where it is used, or a warning where the step of the deck is longer
// than an earthquake takes to slip by L. Collective.
template <int Dim>
void describeSmallestStep(Problem<Dim> const& problem, ParameterList const& deck,
                          Description& description);
} // namespace asperity::scenario
