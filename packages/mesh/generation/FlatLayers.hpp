#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::mesh
{
// Planes beside which cells are flat.
struct FlatLayers
{
  int axis = 2;                  // 0, 1, 2: normal to x, y, z
  std::vector<double> positions; // along that axis [m]
  double height = 0.3;           // of the first layer over its present height, in (0, 1]
};

// Moves the vertices of a box towards planes, so that layers of cells along these have heights of
// `height` times theirs, 1.5 times as much in the next, and so on until they have their own; what
// they lose those beyond them gain, up to the next plane or the end of the box. The height of a
// layer is the smallest of the cells that touch the plane. Throws an InputError that starts with
// `where` if a plane does not lie along facets of cells, or if too few layers lie between it and
// the next plane or the end.
//
// Linear tetrahedra make a fault stiffer than rock, by an error of (k h)^2 that nearly vanishes
// with their height (verification.fault_stiffness); two layers more halve it.
template <int Dim>
void flattenLayers(GlobalMesh<Dim>& mesh, FlatLayers const& layers, std::string const& where);
} // namespace asperity::mesh
