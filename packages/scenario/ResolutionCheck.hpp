#pragma once

#include "dynamics/FaultResolution.hpp"
#include "scenario/Problem.hpp"

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
// model takes as built and what is known of the solver's. Collective.
template <int Dim>
std::vector<std::string> describeSize(Problem<Dim> const& problem);

// Lines for the log, with a warning if there are fewer than three cells per cohesive zone.
std::vector<std::string> describe(dynamics::FaultResolution const& resolution);
} // namespace asperity::scenario
