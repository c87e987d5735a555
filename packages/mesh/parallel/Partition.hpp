#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::mesh
{
struct PartitionOptions
{
  // The vertices of this boundary are balanced, too, since the work of friction is at these
  // vertices alone: parts with equal numbers of vertices may leave one rank with the whole fault.
  // Among all vertices they count `boundary_weight` times. The name is "" if there is no such
  // boundary.
  std::string boundary;
  int boundary_weight = 4;

  // Balances what a mesh has when every cell is refined, instead of vertices: a vertex counts as
  // often as it has cells, and in the boundary as often as it has facets there. boundary_weight
  // then means nothing.
  bool by_cells = false;
};

// The owner of every vertex, 0 <= owner < num_parts, by METIS's k-way partition of the graph whose
// edges are those of the cells. It aims at 3 % above the mean at most for all vertices, weighted,
// and at 5 % for those of the boundary, unless there are fewer of these than parts. Both vertices
// of a pair at a fault inside the body have one owner: for METIS they are one. Every part has a
// vertex. The same input gives the same answer. InputError if there are more parts than vertices.
template <int Dim>
std::vector<int> partitionVertices(GlobalMesh<Dim> const& mesh, int num_parts,
                                   PartitionOptions const& options = {});

// The largest part's number of vertices divided by the mean of all parts, 1 at best. It counts all
// vertices, or some of them (at least one).
double imbalance(std::vector<int> const& owners, int num_parts);
double imbalance(std::vector<int> const& owners, int num_parts, std::vector<int> const& vertices);

// The part of a rank: its vertices, the ghosts, all cells and facets that touch its vertices, and
// of every pair at a fault inside the body either both vertices or none. Owned vertices and ghosts
// are each in the order of their global ids, which are the vertex numbers of the whole mesh; so on
// one rank the part is the mesh. Cells and facets keep their order and their first vertex: a cell
// is counted once if it is counted where its first vertex is owned.
template <int Dim>
Mesh<Dim> localPart(GlobalMesh<Dim> const& mesh, std::vector<int> const& owners, int rank);

// A part with the numbers that its cells and facets have in the whole mesh.
template <int Dim>
struct NumberedPart
{
  Mesh<Dim> mesh;
  std::vector<int> cells;                         // (mesh.cells.size()), ascending
  std::map<std::string, std::vector<int>> facets; // per boundary, as mesh.boundaries; ascending
};

// All parts at once, each as localPart, in a time proportional to the mesh and not to the parts.
template <int Dim>
std::vector<NumberedPart<Dim>> localParts(GlobalMesh<Dim> const& mesh,
                                          std::vector<int> const& owners, int num_parts);

// Partitions the mesh as rank 0 finds it and returns the part of this rank. `mesh` is the same on
// every rank. Collective.
template <int Dim>
Mesh<Dim> distribute(GlobalMesh<Dim> const& mesh, Communicator const& communicator,
                     PartitionOptions const& options = {});

// Gives every rank the mesh of rank 0. Collective.
template <int Dim>
void broadcast(GlobalMesh<Dim>& mesh, Communicator const& communicator);
} // namespace asperity::mesh
