#pragma once

#include "fem/constraints/VertexTerms.hpp"
#include "fem/constraints/detail/ConditionDirections.hpp"

namespace asperity::fem::detail
{
// Turns conditions on the vectors v+ and v- at the two vertices of owned pairs into conditions on
// the unknowns of their nodes (VertexTerms), the mean m and the jump d:
//
//   v+ . e = f+ and v- . e = f-   become   m . e = (f+ + f-)/2 and d . e = f+ - f-
//
// and likewise at the four vertices of a crossing. There the combination that is held has to be
// zero: the node of `both` gets the conditions on it and, before each, an empty velocity along e.
//
// and at the three vertices of a joint, first over the branch, then over the main fault. There the
// jump over the branch has the conditions across both faults, and what is prescribed for the slip
// of the branch holds for its part at right angles to these.
//
// Conditions on the fault itself hold for d without change. At a tip, where d = 0, only the
// condition across the fault remains, because it determines the frame. InputError where only one
// side has a condition along e.
template <int Dim>
NodalDirections meansAndJumps(NodalDirections const& directions, Mesh<Dim> const& mesh,
                              std::vector<VelocityCondition<Dim>> const& conditions,
                              VertexTerms const& terms);
} // namespace asperity::fem::detail
