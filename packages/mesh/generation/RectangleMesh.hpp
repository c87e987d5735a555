#pragma once

#include "mesh/generation/Bisection.hpp"

namespace asperity::mesh
{
struct RectangleShape
{
  double width = 1.0;  // m
  double height = 1.0; // m
  int cells_x = 1;     // columns of two triangles each
  int cells_y = 1;
  Point<2> lower_left = {0.0, 0.0};
  VertexLimit limit = {1e9, "Take fewer cells."};
};

// Right triangles, two in each rectangle, with diagonals whose direction alternates along rows and
// columns.
// Vertices are numbered row by row from the lower left: (i, j) has the number j (cells_x + 1) + i.
// Boundaries `bottom`, `top`, `left`, `right`; region `body`. Throws InputError if the shape is not
// valid.
GlobalMesh<2> rectangleMesh(RectangleShape const& shape);
} // namespace asperity::mesh
