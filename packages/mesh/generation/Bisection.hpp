#pragma once

#include "mesh/GlobalMesh.hpp"

#include <functional>
#include <string>

namespace asperity::mesh
{
using Triangle = std::array<Point<2>, 3>;
using Tetrahedron = std::array<Point<3>, 4>;

// The largest diameter (longest edge, in m) that is allowed for a cell with these corners, which
// may coincide. It has to be positive.
template <int Dim>
using SizeFunction = std::function<double(std::array<Point<Dim>, Dim + 1> const&)>;

// How many vertices a mesh may have, and the advice in the message if it would have more.
struct VertexLimit
{
  double most = 1e7;
  std::string advice = "Is the cell size meant in m?";
};

// Throws an InputError unless 0 < value < infinity. `name`: of the parameter, below Mesh.
void requirePositive(double value, std::string const& name);

// Throws an InputError that says how many vertices there would be, and the advice.
void requireFewVertices(double num_vertices, VertexLimit const& limit);

// Refines a mesh by bisection until no cell exceeds its allowed diameter, with no more bisections
// than that and conformity require. Triangles: newest vertex bisection; tetrahedra: Arnold,
// Mukherjee & Pouly, SIAM J. Sci. Comput. 22 (2000), 431. The refinement edges of the given cells
// are their longest edges. Regions, boundaries and periods are inherited. Angles stay away from
// zero: the descendants of a cell have finitely many shapes, those of a triangle four, those of a
// sixth of a cube three. Throws InputError if more vertices than the limit are needed, before any
// bisection if an estimate shows it.
template <int Dim>
GlobalMesh<Dim> bisect(GlobalMesh<Dim> const& mesh, SizeFunction<Dim> const& largest_diameter,
                       VertexLimit const& limit = {});

// The wanted size of cells at a point, in m. It has to be positive.
template <int Dim>
using CellSize = std::function<double(Point<Dim> const&)>;

// The diameter that a cell size allows a cell: the square root of the dimension times the smallest
// size found at its corners, the midpoints of its edges and its centroid. The sides of squares and
// cubes cut into simplices are then no longer than the size. They are as long, up to rounding, if
// the size is that of the first cells' sides divided by a power of two.
template <int Dim>
SizeFunction<Dim> largestDiameter(CellSize<Dim> const& size);

// Refines by bisection a mesh of rectangles or cuboids with these sides [m], each cut into
// simplices. They keep their proportions, and the cell size limits their longest side: the mesh is
// bisected in coordinates stretched along the short sides, in which it consists of squares or
// cubes.
template <int Dim>
GlobalMesh<Dim> bisectBricks(GlobalMesh<Dim> mesh, Point<Dim> const& brick,
                             CellSize<Dim> const& size, VertexLimit const& limit = {});
} // namespace asperity::mesh
