#pragma once

#include "mesh/GlobalMesh.hpp"

#include <string>
#include <vector>

namespace asperity::mesh
{
// Moves vertices towards boundaries or faults inside the body, so that the layers of cells beside
// these have heights of `height` times theirs, 1.5 times as much in the next, and so on until they
// have their own (LayerHeights); what they lose, cells beyond gain, over three times the length
// that is lost. The height of a layer is that of the cells at the nearest point of the surface.
// Vertices on other parts of the outer boundary stay in its planes, and on its edges; other faults
// inside and interfaces of regions move along unless they are named, too. A vertex moves less where
// a cell would lose more than four fifths of what it is to keep.
//
// For any mesh, plane or not; flattenLayers is for the planes of a box. Call it before faults are
// split. Throws an InputError that starts with `where` for a name that the mesh lacks and for a
// periodic mesh.
template <int Dim>
void flattenBeside(GlobalMesh<Dim>& mesh, std::vector<std::string> const& names, double height,
                   std::string const& where);
} // namespace asperity::mesh
