#pragma once

#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"

#include "mesh/GlobalMesh.hpp"

namespace asperity::geometry
{
// Moves vertices of cells with dihedral angles below `wanted` [degrees] where that increases the
// smallest angle of the cells around them. Vertices inside the volume move freely, those of a patch
// along its surface, those of a curve along the curve; corners stay. Returns the number of cells
// whose angles remain below `wanted`.
int relocateVertices(GlobalMesh<3>& mesh, Complex const& complex, Model const& model,
                     double wanted);
} // namespace asperity::geometry
