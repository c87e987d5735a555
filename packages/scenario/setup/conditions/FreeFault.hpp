#pragma once

#include "mesh/Mesh.hpp"
#include "scenario/setup/conditions/BoundarySetup.hpp"

namespace asperity::scenario
{
// Throws InputError, on all ranks, if conditions that hold on a facet of a fault with friction
// prescribe its velocity in every direction along it, so that friction decides on nothing there.
// Nodes where a fault ends at another boundary may be held: conditions are compared by facets. The
// mesh has all boundaries that the conditions name. Collective.
template <int Dim>
void requireFreeFault(BoundaryConditions<Dim> const& boundary, Mesh<Dim> const& mesh,
                      int components, Communicator const& communicator);
} // namespace asperity::scenario
