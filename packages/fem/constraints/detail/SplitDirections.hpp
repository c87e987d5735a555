#pragma once

#include "fem/constraints/detail/ConditionDirections.hpp"

namespace asperity::fem::detail
{
// Turns conditions on the vectors v+ and v- at the two vertices of owned pairs into conditions on
// what their nodes carry (VertexTerms), the mean m and the jump d:
//
//   v+ . e = f+ and v- . e = f-   become   m . e = (f+ + f-)/2 and d . e = f+ - f-
//
// Conditions on the fault itself are about its slip, and hold for d as they are. At a tip only its
// normal stays, for the frame: d = 0 there. InputError where only one side has a condition along e.
template <int Dim>
NodalDirections meansAndJumps(NodalDirections directions, Mesh<Dim> const& mesh,
                              std::vector<VelocityCondition<Dim>> const& conditions);
} // namespace asperity::fem::detail
