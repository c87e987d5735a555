#pragma once

#include "fem/FaultSurface.hpp"
#include "scenario/setup/NodalField.hpp"

namespace asperity::scenario
{
// Declares `Averaged Fields`.
void declareAveragedFields(Declare& declare);

// The nodes of a fault. Fields that `Averaged Fields` in the list `Friction` names have their means
// over the facets around each node, weighted with the node's basis function, so that the integral
// over the fault of a field that jumps is right, but for the points at which it is read: 8 on a
// segment, 16 on a triangle. Other fields have their values at the nodes. InputError where there is
// no field of such a name.
template <int Dim>
FieldNodes faultNodes(Mesh<Dim> const& mesh, fem::FaultSurface const& surface,
                      ParameterList const& friction);
} // namespace asperity::scenario
