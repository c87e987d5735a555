#pragma once

#include "arrangement/Arranged.hpp"
#include "arrangement/complex/Box.hpp"
#include "arrangement/complex/Complex.hpp"
#include "meshing/CellEstimate.hpp"
#include "surfaces/TriangleSurface.hpp"

#include "mesh/GlobalMesh.hpp"

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity::geometry
{
// A fault, or a part of one, as a plane that fits it.
struct FaultShape
{
  double area = 0;   // [m^2]
  double strike = 0; // degrees clockwise from y; the fault dips to the right of it
  double dip = 0;    // degrees from the horizontal
};
FaultShape shapeOf(std::vector<Point<3>> const& points, std::vector<Triangle> const& triangles);

// The largest distance [m] of the centroids of facets from a surface, and where.
struct DistanceAt
{
  double distance = 0;
  Point<3> place{};
};
DistanceAt largestDistance(std::vector<Point<3>> const& points, std::vector<Triangle> const& facets,
                           TriangleSurface const& surface);

// The cells with the smallest dihedral angles, ascending.
struct CellAngle
{
  double degrees = 180;
  Point<3> place{}; // the centre of the cell
};
std::vector<CellAngle> smallestAngles(GlobalMesh<3> const& mesh, std::size_t number);

// The edges of cells, each once.
struct EdgeLengths
{
  // An edge by its length [m] and its middle.
  struct Edge
  {
    double length = 0;
    Point<3> place{};
  };
  Edge shortest, longest;
  std::size_t number = 0, num_longer = 0; // of all, and of those that are longer than the bound
};
// bound: [m]. The mesh must have a cell.
EdgeLengths edgeLengths(GlobalMesh<3> const& mesh, double bound);

// Reports the arrangement: faults, removed pieces with the reasons, junctions of faults, the
// smallest angle and the shortest curve.
void report(Arranged const& arranged, Model const& model, std::ostream& out);

// The text of an estimate: two digits, without an exponent below a million.
std::string about(double value);

// Reports the expected numbers of cells and vertices.
void report(CellEstimate const& expected, std::ostream& out);

// Reports the facets of faults, the cells with the smallest angles, the shortest edge, and those
// longer than `largest` [m], the size of cells that the deck wants; the mesh may be split or not.
void report(GlobalMesh<3> const& mesh, Model const& model, double largest, std::ostream& out);
} // namespace asperity::geometry
