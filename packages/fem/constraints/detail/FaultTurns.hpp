#pragma once

#include "fem/constraints/VelocityCondition.hpp"

#include <vector>

namespace asperity::fem::detail
{
// Sets the turn of each condition with the normal of a fault in two dimensions (see tangentOf), so
// that all tangents of a set of faults and continuations that meet end to end have one sense. Their
// mean points to +x, or to +y if it is steeper. The sense of a set does not depend on other ones;
// a fault that branches off another one is a set of its own. Collective.
template <int Dim>
void chooseTurns(Mesh<Dim> const& mesh, Communicator const& communicator,
                 std::vector<VelocityCondition<Dim>>& conditions);
} // namespace asperity::fem::detail
