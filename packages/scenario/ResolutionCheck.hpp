#pragma once

#include "dynamics/FaultResolution.hpp"
#include "scenario/Problem.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::scenario
{
// How well the mesh resolves ruptures at the start. Nothing where friction weakens nowhere, or
// where the laws do not say what a, b and L are. Collective.
template <int Dim>
std::optional<dynamics::FaultResolution> faultResolution(Problem<Dim> const& problem,
                                                         ParameterList const& friction);

// For the log, with a warning below three cells per cohesive zone.
std::vector<std::string> describe(dynamics::FaultResolution const& resolution);
} // namespace asperity::scenario
