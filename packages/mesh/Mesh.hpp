#pragma once

#include "base/Types.hpp"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace asperity
{
template <int Dim>
using Point = std::array<double, Dim>;

// Two vertices at one place, on the two sides of a fault inside the body.
struct SplitVertex
{
  int plus = 0;
  int minus = 0;
  bool is_tip = false;
};

// The part of a conforming mesh of simplices that one rank works on.
//
// Every vertex is owned by one rank. A rank holds all cells, and all boundary facets, that touch
// one of its vertices, so that its rows of every matrix are complete without communication.
// Vertices are numbered locally: the owned ones first, then the ghosts. Coordinates in m.
//
// Where the mesh is periodic, opposite sides are one set of vertices with the lower coordinate, and
// some cells reach across the period: corners() gives their geometry (SimplexGeometry.hpp).
template <int Dim>
struct Mesh
{
  using Cell = std::array<int, Dim + 1>;
  using Facet = std::array<int, Dim>;

  std::vector<Point<Dim>> vertices;      // (num_local)
  std::vector<GlobalOrdinal> global_ids; // (num_local), 0 <= id < num_global_vertices
  int num_owned = 0;                     // vertices 0 .. num_owned - 1
  GlobalOrdinal num_global_vertices = 0;
  Point<Dim> period{}; // along each axis, in m; 0 where not periodic

  std::vector<Cell> cells;               // local vertex numbers, positively oriented
  std::vector<int> cell_regions;         // (num_cells), index into region_names
  std::vector<std::string> region_names; // the same on every rank

  // Facets by name of the boundary; every rank has every name, perhaps without facets.
  // Outward orientation: the body lies to the left of a 2D facet (first -> second vertex), and the
  // right-hand normal of a 3D facet points out of it.
  std::map<std::string, std::vector<Facet>> boundaries;

  std::vector<std::string> faults; // boundaries that are faults inside the body
  std::vector<SplitVertex> splits; // ascending in plus
};
} // namespace asperity
