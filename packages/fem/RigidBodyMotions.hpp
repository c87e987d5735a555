#pragma once

#include "fem/DofMap.hpp"
#include "fem/constraints/NodalFrames.hpp"
#include "mesh/Mesh.hpp"

namespace asperity::fem
{
// The motions that need no force, as components in nodal frames on the owned dofs: translations
// along the axes, then rotations about axes through the centre of the vertices, divided by half
// the body's size, so that all columns are of order 1. There is one in antiplane motion, 3 in 2D
// and 6 in 3D. A periodic body lacks the rotations that its copies cannot follow: all but the one
// about the axis of its period, if it has one period. Nothing jumps over a fault. Collective.
template <int Dim>
RCP<const MultiVector> rigidBodyMotions(Mesh<Dim> const& mesh, DofMap const& dofs,
                                        NodalFrames const& frames);
} // namespace asperity::fem
