#pragma once

#include "mesh/generation/Bisection.hpp"

#include <vector>

namespace asperity::mesh
{
// The subduction wedge of Pipping 2014, fig. 5.2 and A.1: a right triangle between surface, back
// and base, turned by th = atan(height / length) so that the base lies along x and the trench tip
// at (0, 0). Gravity points along (sin th, -cos th). Lengths in m.
struct WedgeShape
{
  double length = 1.0;             // of the surface
  double height = 0.27;            // of the right face
  double zone_width = 0.20;        // of the seismogenic zone, along the base
  double zone_end = 0.35;          // its lower end, measured along the surface from the trench
  double cell_size = 0.002;        // largest diameter of a cell at the seismogenic zone
  double growth_factor = 8.0;      // s
  double growth_length = 0.10;     // l
  double viscous_thickness = 0.06; // of region `lower`, vertically from the deepest point
  // Intervals of the base, x in m, with cells of the same size as at the seismogenic zone.
  std::vector<Point<2>> further_zones = {};
  VertexLimit limit = {};

  double angle() const;      // th in rad
  double baseLength() const; // sqrt(length^2 + height^2)
  double zoneLeft() const;   // ends of the seismogenic zone on the base, x in m
  double zoneRight() const;
  Point<2> gravityDirection() const;
};

// Cells are bisected while they exceed (s d / l + 1) times the cell size, where d is the distance
// of the cell from the nearest zone, seismogenic or further. Boundaries `base`, `right`, `surface`;
// regions `upper` and `lower`. Throws InputError if the shape is not valid.
GlobalMesh<2> wedgeMesh(WedgeShape const& shape = {});

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
