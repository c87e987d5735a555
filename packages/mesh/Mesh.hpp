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

// Two vertices at one place, on the two sides of a fault inside the body. At a tip the body is not
// cut: no cell refers to `plus`, only facets of the fault do, and `minus` is the vertex of the
// cells around it. Where a fault branches off another one, the `minus` of its tip is the vertex on
// the side of the other fault on which the branch lies, and may itself be the plus of a pair. At a
// joint (Joints.hpp) this is so, too, but the branch has slip there along the other fault, and its
// cells on its plus side have `plus`. Where two faults cross, three pairs have one minus
// (Crossings.hpp).
struct SplitVertex
{
  int plus = 0;
  int minus = 0;
  bool is_tip = false;
  bool is_joint = false; // never with is_tip
};
inline bool operator==(SplitVertex const& a, SplitVertex const& b)
{
  return a.plus == b.plus && a.minus == b.minus && a.is_tip == b.is_tip && a.is_joint == b.is_joint;
}

// The part of a conforming mesh of simplices that one rank works on.
//
// Every vertex is owned by one rank. A rank holds all cells, and all boundary facets, that touch
// one of its vertices, so that its rows of every matrix are complete without communication.
// Vertices are numbered locally: the owned ones first, then the ghosts. Coordinates in m.
//
// Where the mesh is periodic, opposite sides are one set of vertices with the lower coordinate, and
// some cells reach across the period: corners() gives their geometry (SimplexGeometry.hpp).
//
// Along the faults inside the body the mesh is split (faults/SplitFaults.hpp): cells on the two
// sides have no vertex in common except at the tips. Both vertices of a pair are owned by one rank,
// and a rank that has one of them has the other, so that ghosts may be without a cell.
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
  //
  // The facets of a fault inside the body are those of its plus side, oriented outward from the
  // body there. They consist of plus vertices only, also at tips; with minus instead of plus they
  // are the facets of the other side, but for corners at crossings and joints (SplitVertices.hpp
  // gives both sides). Their normal points from plus to minus.
  std::map<std::string, std::vector<Facet>> boundaries;

  std::vector<SplitVertex> splits; // local vertex numbers, ascending in plus
  std::vector<std::string> faults; // boundaries inside the body, sorted; the same on every rank
};
} // namespace asperity
