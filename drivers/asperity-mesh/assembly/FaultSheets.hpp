#pragma once

#include "mesh/GlobalMesh.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// The sheets of a fault: where more than two of its facets meet, those that bend least go on into
// each other, on the average of all places where the same parts of the fault meet. Each sheet has
// the numbers of its facets; the largest one comes first. One sheet if at most two facets meet
// anywhere, also if they are not connected.
template <int Dim>
std::vector<std::vector<int>> sheetsOf(std::vector<Point<Dim>> const& vertices,
                                       std::vector<typename GlobalMesh<Dim>::Facet> const& facets);

// Divides the fault NAME of several sheets into NAME.1, NAME.2 ... and tells it. InputError, which
// starts with `where`, if there is a boundary of such a name.
template <int Dim>
void divideIntoSheets(GlobalMesh<Dim>& mesh, std::string const& name, std::string const& where);
} // namespace asperity::geometry
