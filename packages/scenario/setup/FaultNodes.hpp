#pragma once

#include "fem/FaultSurface.hpp"
#include "scenario/setup/NodalField.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The nodes of a surface of these faults. A node of several faults belongs to the first of them;
// where two faults cross, each has nodes of its own.
//
// mean(f) in their fields is the mean of f over the facets around a node, weighted with the node's
// basis function, so that the integral of mean(f) over the fault is that of f. The integrals are
// sums over 8 points of a segment or 16 of a triangle. Mesh and surface have to outlive the result.
template <int Dim>
FieldNodes faultNodes(Mesh<Dim> const& mesh, fem::FaultSurface const& surface,
                      std::vector<std::string> const& faults);
} // namespace asperity::scenario
