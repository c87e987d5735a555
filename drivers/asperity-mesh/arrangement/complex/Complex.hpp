#pragma once

#include "surfaces/TriangleSurface.hpp"

#include "mesh/Mesh.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace asperity::geometry
{
using Triangle = std::array<int, 3>;
using Edge = std::array<int, 2>; // ascending

inline Edge edgeOf(int a, int b) { return {std::min(a, b), std::max(a, b)}; }
// The edge from corner k to the next one.
inline Edge edgeOf(Triangle const& triangle, int k)
{
  return edgeOf(triangle[k], triangle[(k + 1) % 3]);
}

struct NamedSurface
{
  std::string name;
  TriangleSurface surface;
};

// Triangles of several surfaces, which have vertices and edges in common where the surfaces meet.
struct Complex
{
  std::vector<Point<3>> points;    // [m]
  std::vector<Triangle> triangles; // as oriented as their surface
  std::vector<int> surfaces;       // (num_triangles) the surface that each is a part of
};

// The triangles at each edge, ascending.
using TrianglesAtEdges = std::map<Edge, std::vector<int>>;
TrianglesAtEdges trianglesAtEdges(std::vector<Triangle> const& triangles);

// Not normalised: its length is twice the area.
Point<3> normalOf(std::vector<Point<3>> const& points, Triangle const& triangle);
double areaOf(std::vector<Point<3>> const& points, Triangle const& triangle); // [m^2]
double areaOf(TriangleSurface const& surface);                                // [m^2]
Point<3> centroidOf(std::vector<Point<3>> const& points, Triangle const& triangle);
// From an edge into a triangle at it, at right angles to the edge, of length 1.
Point<3> inward(std::vector<Point<3>> const& points, Edge const& edge, Triangle const& triangle);

// Removes the other triangles, and the points without a triangle. `points`, if given, gets the new
// number of each point, or -1.
void keepTriangles(Complex& complex, std::vector<bool> const& is_kept,
                   std::vector<int>* points = nullptr);

// "(1.2, -3, 0) km", for messages.
std::string placeText(Point<3> const& place);
// "x from -5 to 5 km, y ..., z ..."
std::string extentText(std::vector<Point<3>> const& points);
// The diagonal of the bounding box of points, at least one [m].
double extentOf(std::vector<Point<3>> const& points);
} // namespace asperity::geometry
