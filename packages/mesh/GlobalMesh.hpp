#pragma once

#include "mesh/Mesh.hpp"

namespace asperity
{
// A whole conforming mesh of simplices, the same on every rank that has it: what generators make
// and files hold. Members as in Mesh, with global vertex numbers.
//
// A fault inside the body is at first a boundary whose facets have two cells each (addFaults
// names them); splitFaults makes a mesh with `splits` and `faults` of it.
template <int Dim>
struct GlobalMesh
{
  using Cell = std::array<int, Dim + 1>;
  using Facet = std::array<int, Dim>;

  std::vector<Point<Dim>> vertices; // (num_vertices) in m
  Point<Dim> period{};              // along each axis, in m; 0 where not periodic
  std::vector<Cell> cells;          // positively oriented
  std::vector<int> cell_regions;    // (num_cells), index into region_names
  std::vector<std::string> region_names;
  std::map<std::string, std::vector<Facet>> boundaries; // outward orientation, as in Mesh
  std::vector<SplitVertex> splits;                      // ascending in plus; empty before the split
  std::vector<std::string> faults;                      // sorted; empty before the split
};

namespace mesh
{
// Throws an InputError that starts with `where` (a file or a parameter list) unless the mesh is
// valid: coordinates are finite, vertex numbers and regions are in range, every cell is positively
// oriented, every vertex is in a cell, no facet is in more than two cells, no vertex hangs inside
// an edge or a face (detail/Conformity.hpp), and every facet of a boundary is listed once and is in
// one cell or, if the boundary is a fault inside the body, in two cells. In a mesh that is split,
// the pairs and the facets of the faults are as Mesh describes them.
template <int Dim>
void checkMesh(GlobalMesh<Dim> const& mesh, std::string const& where);

// Gives the facets of the boundaries outward orientation. Those of faults stay as they are, and so
// do those that are not facets of a cell; checkMesh names them.
template <int Dim>
void orientFacets(GlobalMesh<Dim>& mesh);

// Swaps two vertices of every cell with negative volume; returns how many there were.
template <int Dim>
int orientCells(GlobalMesh<Dim>& mesh);
} // namespace mesh
} // namespace asperity
