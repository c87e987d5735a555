#pragma once

#include <array>
#include <string>
#include <vector>

namespace asperity::geometry
{
// The shapes of cells in other programs, by dimension and number of corners: in the plane triangle
// (3) and quadrilateral (4); in space tetrahedron (4), pyramid (5), prism (6) and hexahedron (8).
// Corners are in the order of Gmsh, VTK, Exodus and Abaqus: the base, then what is above it.

constexpr int most_corners = 8;

// The sides of a cell as places among its corners, outward if the cell is positively oriented;
// empty for what is not one of the shapes above.
std::vector<std::vector<int>> const& sidesOf(int dimension, int num_corners);

// The number of corners of a cell that has this number of nodes, as a cell of first or second
// order; 0 if there is none.
int cornersOfCell(int dimension, int num_nodes);

std::string shapeName(int dimension, int num_corners); // "hexahedron"

// Cuts a cell or a side into simplices, each of dimension + 1 vertices. All of them have the
// smallest vertex, and so has the cut of each side: cells that share a side cut it alike. They are
// oriented as what is cut. One simplex stays as it is; one with a vertex twice, of a cell whose
// corners coincide, is left out.
std::vector<std::vector<int>> simplicesOf(int dimension, std::vector<int> const& corners);
} // namespace asperity::geometry
