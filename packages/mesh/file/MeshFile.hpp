#pragma once

#include "mesh/GlobalMesh.hpp"

// Meshes in HDF5:
//
//   /                           attributes format = "asperity-mesh", version = 1, dimension;
//                               if periodic, period (dimension) in m, 0 along the other axes
//   /vertices                   (num_vertices, dimension)    coordinates in m
//   /cells                      (num_cells, dimension + 1)   vertex numbers from 0, positively
//                                                            oriented
//   /cell_regions               (num_cells)                  index into region_names
//   /region_names               (num_regions)                strings
//   /boundaries/<name>/facets   (num_facets, dimension)      vertex numbers, in any order
//
// A boundary whose facets have two neighbouring cells each is a fault inside the body; the mesh is
// not split in the file (faults/SplitFaults.hpp).
//
// Coordinates may be integers or floating-point numbers of any width, all other numbers integers of
// any width; strings may have fixed or variable length.
namespace asperity::mesh
{
// Overwrites an existing file. The file is written under another name and then renamed, so that it
// is complete if it exists. The mesh is not split. Throws InputError if it cannot be written.
template <int Dim>
void writeMesh(GlobalMesh<Dim> const& mesh, std::string const& file_name);

// The mesh of the file, after checkMesh. Throws an InputError with the name of the file if the file
// is missing, malformed, truncated, of another dimension, or not a mesh.
template <int Dim>
GlobalMesh<Dim> readMesh(std::string const& file_name);

// Rank 0 reads, and every rank returns the same mesh or throws the same InputError. Collective.
template <int Dim>
GlobalMesh<Dim> readMesh(std::string const& file_name, Communicator const& communicator);

// The attribute `dimension`, 2 or 3; InputError as readMesh.
int meshDimension(std::string const& file_name);
} // namespace asperity::mesh
