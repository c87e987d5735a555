#pragma once

#include "base/parameters/Parameters.hpp"
#include "mesh/Mesh.hpp"
#include "scenario/setup/ConditionTypes.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// In the order of the deck.
std::vector<BoundaryCondition> readConditions(ParameterList const& list);

// InputError with both names where two conditions on a boundary exclude each other, by what their
// Types decide on.
void refuseContradictions(std::vector<BoundaryCondition> const& conditions);

// InputError for an entry that the condition's Type does not read.
void refuseUnreadEntries(std::vector<BoundaryCondition> const& conditions);

// InputError with the nearest name for a boundary that the mesh does not have. The names are the
// same on all ranks.
template <int Dim>
void requireBoundaries(ParameterList const& list, Mesh<Dim> const& mesh);

// InputError unless conditions on faults inside the body are those of two-sided faults, conditions
// of two-sided faults are on these alone, and each of these has one. After requireBoundaries.
template <int Dim>
void requireFaults(ParameterList const& list, Mesh<Dim> const& mesh);
} // namespace asperity::scenario
