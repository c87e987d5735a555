#pragma once

#include "scenario/setup/conditions/ConditionTypes.hpp"

// What conditions along faults contribute.
namespace asperity::scenario
{
// Adds a fault of the condition's kind, with its plate rate. Throws InputError for a second fault
// unless both lie inside the body, and for one that may open in antiplane motion or with a slip
// rate. The surface of all faults may open if one of them may.
template <int Dim>
void addFault(BoundaryCondition const& condition, ConditionContext const& context,
              BoundaryConditions<Dim>& result);

// Adds the condition on the velocity of a fault, or of its continuation, that the entries
// `Slip Rate` and `Direction` describe: v_t = (slip rate - Vp) / slip factor, where Vp is the plate
// rate. It points along the tangent of the frames, in three dimensions along the projection of the
// direction onto the boundary. `result` has the faults.
template <int Dim>
void prescribeSlipRate(BoundaryCondition const& condition, ConditionContext const& context,
                       BoundaryConditions<Dim>& result);
} // namespace asperity::scenario
