#pragma once

#include "fem/constraints/NodalFrames.hpp"
#include "fem/dofs/DofMap.hpp"
#include "mesh/Mesh.hpp"

namespace asperity::fem
{
// The motions that need no force, as components in nodal frames on the owned dofs: translations
// along the axes, then rotations about axes through the centre of the body's bounding box, divided
// by half its longest side, so that all columns are of order 1. There is one in antiplane motion, 3
// in 2D and 6 in 3D. A periodic body in 3D has only the rotation about the axis of its period, if
// it has one period; other periodic bodies have no rotation. The jumps across faults are zero.
// Collective.
template <int Dim>
RCP<const MultiVector> rigidBodyMotions(Mesh<Dim> const& mesh, DofMap const& dofs,
                                        NodalFrames const& frames);
} // namespace asperity::fem
