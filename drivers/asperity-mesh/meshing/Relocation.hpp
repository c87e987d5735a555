#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"

#include "mesh/GlobalMesh.hpp"

namespace asperity::geometry
{
// Moves vertices of cells with dihedral angles below `wanted` [degrees] where that makes the
// smallest angle of the cells around them larger: vertices inside the volume freely, those inside a
// patch of a surface along it, those on a curve along the curve. Corners stay. Returns the number
// of cells that remain below.
int relocateVertices(GlobalMesh<3>& mesh, Complex const& complex, Model const& model,
                     double wanted);
} // namespace asperity::geometry
