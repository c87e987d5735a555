#pragma once

#include "mesh/generation/WedgeMesh.hpp"

namespace asperity::mesh
{
// The wedge extruded along z, from 0 to its depth.
struct DeepWedge
{
  double depth = 0.10; // m along z
  // Intervals of z [m] that the seismogenic zone occupies; the whole depth if there are none.
  std::vector<std::array<double, 2>> patches;
  bool is_periodic = false; // along z
};

// Tetrahedra that are bisected while they exceed (s d / l + 1) times the cell size, where d is the
// distance of the seismogenic zone from the smallest box around the cell (at most its distance from
// the cell itself). Boundaries `base`, `right`, `surface` and, unless it is periodic, `front` (z =
// 0) and `back` (z = depth); regions as in 2D. Throws InputError if the shape is not valid.
GlobalMesh<3> deepWedgeMesh(WedgeShape const& shape, DeepWedge const& deep);

// wedgeMesh(shape) in equal layers along z.
GlobalMesh<3> layeredWedgeMesh(WedgeShape const& shape, double depth, int num_layers);
} // namespace asperity::mesh
