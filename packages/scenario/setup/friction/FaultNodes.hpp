#pragma once

#include "fem/FaultSurface.hpp"
#include "scenario/setup/NodalField.hpp"

namespace asperity::scenario
{
// Declares `Field Values`.
void declareFieldValues(Declare& declare);

// The nodes of a fault, at which the deck's fields have the values that `Field Values` in the list
// `Friction` selects: those at the nodes, or means over the facets around them, weighted with the
// nodes' basis functions. The integral over the fault of a field that jumps is then exact, but for
// the points at which the field is read: 8 on a segment, 16 on a triangle.
template <int Dim>
FieldNodes faultNodes(Mesh<Dim> const& mesh, fem::FaultSurface const& surface,
                      ParameterList const& friction);
} // namespace asperity::scenario
