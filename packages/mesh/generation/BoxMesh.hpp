#pragma once

#include "mesh/generation/Bisection.hpp"

namespace asperity::mesh
{
struct BoxShape
{
  Point<3> size = {1.0, 1.0, 1.0};       // m
  std::array<int, 3> num_cells{1, 1, 1}; // along the axes, of six tetrahedra each
  Point<3> lowest_corner{};
  VertexLimit limit = {3e8, "Take fewer cells."};
};

// Bricks cut into six tetrahedra around the diagonal from their lowest to their highest corner
// (Freudenthal, Kuhn). Vertices with x fastest: number (i, j, k) is
// (k (num_cells[1] + 1) + j) (num_cells[0] + 1) + i. Boundaries `left` and `right` (x), `bottom`
// and `top` (y), `front` and `back` (z), the lower one first; region `body`. Throws InputError if
// the shape is not valid.
GlobalMesh<3> boxMesh(BoxShape const& shape);
} // namespace asperity::mesh
