#pragma once

#include "mesh/GlobalMesh.hpp"

namespace asperity::mesh
{
struct PartitionOptions
{
  // Vertices on this boundary count `boundary_weight` times, since friction makes them dearer; none
  // if "".
  std::string boundary;
  int boundary_weight = 4;
};

// The owner of every vertex, 0 <= owner < num_parts, by METIS's k-way partition of the graph whose
// edges are those of the cells. Every part has a vertex. The same input gives the same answer.
// InputError if there are more parts than vertices.
template <int Dim>
std::vector<int> partitionVertices(GlobalMesh<Dim> const& mesh, int num_parts,
                                   PartitionOptions const& options = {});

// The part of a rank: its vertices, the ghosts, all cells and facets that touch its vertices. Owned
// vertices and ghosts are each in the order of their global ids, which are the vertex numbers of
// the whole mesh; so on one rank the part is the mesh. Cells and facets keep their order and their
// first vertex: a cell is counted once if it is counted where its first vertex is owned.
template <int Dim>
Mesh<Dim> localPart(GlobalMesh<Dim> const& mesh, std::vector<int> const& owners, int rank);

// Partitions on rank 0 and returns each rank its part. `mesh` is the same on every rank.
// Collective.
template <int Dim>
Mesh<Dim> distribute(GlobalMesh<Dim> const& mesh, Communicator const& communicator,
                     PartitionOptions const& options = {});

// Gives every rank the mesh of rank 0. Collective.
template <int Dim>
void broadcast(GlobalMesh<Dim>& mesh, Communicator const& communicator);
} // namespace asperity::mesh
