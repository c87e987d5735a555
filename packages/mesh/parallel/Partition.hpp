#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::mesh
{
struct PartitionOptions
{
  // The vertices of this boundary are balanced, too, since friction causes work only there: parts
  // with equal numbers of vertices may leave one rank with the whole fault. In the balance of all
  // vertices, one of these counts `boundary_weight` times. "" for no boundary.
  std::string boundary;
  int boundary_weight = 4;

  // Balances the mesh that results if every cell is refined: a vertex counts once for each of its
  // cells and, in the balance of the boundary, once for each of its facets there. boundary_weight
  // then has no effect.
  bool by_cells = false;
};

// The owner of every vertex, 0 <= owner < num_parts, by METIS's k-way partition of the graph whose
// edges are those of the cells. METIS aims at parts of at most 3 % above the mean weight of all
// vertices, and 5 % for the vertices of the boundary, unless there are fewer of these than parts.
// Both vertices of a pair at a fault inside the body have one owner: for METIS they are one. Every
// part has a vertex. Deterministic. InputError if there are more parts than vertices.
template <int Dim>
std::vector<int> partitionVertices(GlobalMesh<Dim> const& mesh, int num_parts,
                                   PartitionOptions const& options = {});

// The number of vertices of the largest part divided by the mean over all parts, 1 at best; of all
// vertices, or only of the given ones (at least one).
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

// All parts, each as localPart, in a time that does not grow with the number of parts.
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
