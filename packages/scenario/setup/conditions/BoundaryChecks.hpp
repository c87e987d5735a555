#pragma once

#include "mesh/Mesh.hpp"
#include "parameters/Parameters.hpp"
#include "scenario/setup/conditions/ConditionTypes.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// Throws InputError with both names if two conditions on a boundary exclude each other, see
// DecidesOn.
void refuseContradictions(std::vector<BoundaryCondition> const& conditions);

// Throws InputError for an entry that the condition's Type does not read.
void refuseUnreadEntries(std::vector<BoundaryCondition> const& conditions);

// Throws InputError, with the nearest name, for a boundary that the mesh does not have. The names
// are the same on all ranks.
template <int Dim>
void requireBoundaries(std::vector<BoundaryCondition> const& conditions, Mesh<Dim> const& mesh);

// Throws InputError, with both names, the number of common facets and a place, where two conditions
// that say what traction acts share facets under different names: both would act there. Conditions
// on the velocity may share facets, and so may free surfaces. Call after requireBoundaries.
// Collective.
template <int Dim>
void requireOwnFacets(std::vector<BoundaryCondition> const& conditions, Mesh<Dim> const& mesh,
                      Communicator const& communicator);

// Throws InputError where an Antisymmetric Fault and its continuations are not one plane: a facet's
// normal is more than a degree off the mean one. Call after requireBoundaries. Collective.
template <int Dim>
void requirePlaneOfMirror(std::vector<BoundaryCondition> const& conditions, Mesh<Dim> const& mesh,
                          Communicator const& communicator);

// Throws InputError unless every fault inside the body has a condition, these conditions are of
// two-sided faults or of their continuations, and all such conditions are on faults inside the body
// if the deck has a two-sided fault. Names parts of the body that touch there without common
// vertices. Call after requireBoundaries. Collective.
template <int Dim>
void requireFaults(std::vector<BoundaryCondition> const& conditions, Mesh<Dim> const& mesh,
                   Communicator const& communicator);
} // namespace asperity::scenario
