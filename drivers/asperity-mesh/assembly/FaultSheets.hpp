#pragma once

#include "mesh/GlobalMesh.hpp"

#include <string>
#include <vector>

namespace asperity::geometry
{
// The sheets of a fault, largest first, as numbers of facets. Where more than two facets meet, the
// pair of parts with the smallest mean angle between them is joined to one sheet, then the next
// pair; the mean is over all places where the same parts meet. A fault of which at most two facets
// meet anywhere is one sheet, even if it is not connected.
template <int Dim>
std::vector<std::vector<int>> sheetsOf(std::vector<Point<Dim>> const& vertices,
                                       std::vector<typename GlobalMesh<Dim>::Facet> const& facets);

// Divides the fault NAME of several sheets into NAME.1, NAME.2 ... and prints that. InputError,
// which starts with `where`, if there is a boundary of such a name.
template <int Dim>
void divideIntoSheets(GlobalMesh<Dim>& mesh, std::string const& name, std::string const& where);
} // namespace asperity::geometry
