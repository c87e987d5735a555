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
// model takes as built and what is known of the solver's, and what a step will cost, from the
// product of the stiffness matrix with a vector, timed here. Collective.
template <int Dim>
std::vector<std::string> describeSize(Problem<Dim> const& problem);

// Lines for the log, with a warning if there are fewer than three cells per cohesive zone. The
// nucleation length is known for the ageing law; of other laws the lines have the shortest
// wavelength that grows.
std::vector<std::string> describe(dynamics::FaultResolution const& resolution,
                                  std::string const& state_law);
} // namespace asperity::scenario
