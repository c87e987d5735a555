#pragma once

#include "fem/constraints/NodalFrames.hpp"
#include "fem/constraints/VelocityCondition.hpp"
#include "fem/constraints/detail/ConditionDirections.hpp"

#include <vector>

namespace asperity::fem::detail
{
// The turn (tangentOf) of the tangent at a node in two dimensions: that of the first condition that
// leaves its direction free, else that of the first condition; 0 where that one is turned already.
template <int Dim>
int turnAt(std::vector<VelocityCondition<Dim>> const& conditions,
           std::vector<Direction> const& directions);

// The directions that the frame of a node follows, each with the velocity along it, which is empty
// where it is free. Free directions come first, then the `prescribed` ones. Throws InputError where
// a velocity is prescribed obliquely to a free direction.
template <int Dim>
NodalBasis basisOfFrame(std::vector<VelocityCondition<Dim>> const& conditions,
                        std::vector<Direction> const& directions, NodalBasis const& prescribed,
                        Mesh<Dim> const& mesh, int node);

// The frame whose last rows are these directions, the first one in the last row. Its first rows are
// the tangents, in the order of the axes that they are near to. It is not always right-handed.
NodalFrames::Matrix frameFrom(NodalBasis const& basis, int components, int turn);
} // namespace asperity::fem::detail
