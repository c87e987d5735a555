#pragma once

#include "mesh/GlobalMesh.hpp"

#include <set>
#include <string>

namespace asperity::geometry
{
// The boundaries that have facets with two cells: faults that are not split yet.
template <int Dim>
std::set<std::string> faultsOf(GlobalMesh<Dim> const& mesh);

// Leaves a facet inside the body that several groups have to the group with the fewest facets (of
// equal ones the first by name), and warns. InputError, which starts with `where`, if a group would
// have no facet left.
template <int Dim>
void separateFaults(GlobalMesh<Dim>& mesh, std::set<std::string> const& faults,
                    std::string const& where);
} // namespace asperity::geometry
