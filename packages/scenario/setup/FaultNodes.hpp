#pragma once

#include "fem/FaultSurface.hpp"
#include "scenario/setup/NodalField.hpp"

namespace asperity::scenario
{
// The nodes of a fault. mean(f) in their fields is the mean of f over the facets around a node,
// weighted with the node's basis function, so that the integral of mean(f) over the fault is that
// of f, but for the points at which f is read: 8 on a segment, 16 on a triangle. Mesh and surface
// have to outlive the result.
template <int Dim>
FieldNodes faultNodes(Mesh<Dim> const& mesh, fem::FaultSurface const& surface);
} // namespace asperity::scenario
