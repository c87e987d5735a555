#pragma once

#include "mesh/parallel/Partition.hpp"

// Meshes divided for a number of ranks, of which every rank reads its own part alone:
//
//   /                       attributes format = "asperity-partition", version = 2, dimension,
//                           num_parts, num_vertices and num_cells of the whole mesh, period
//                           (dimension) in m with 0 where not periodic, fingerprint of the whole
//                           mesh (16 hexadecimal digits, for any parts), boundary ("" for
//                           none) and boundary_weight as in PartitionOptions
//   /region_names           (num_regions)    strings
//   /boundaries             a group that holds a group for each boundary
//   /faults                 (num_faults)     strings: the boundaries that are faults inside the
//                                            body, along which the mesh is split; missing if there
//                                            are none
//
// and these arrays, whose rows are those of part 0, then those of part 1, and so on:
//
//   /num_owned              (1)              number of vertices that the part owns
//   /vertices               (n, dimension)   coordinates in m, owned vertices before ghosts
//   /global_ids             (n)              of the vertices: their numbers in the whole mesh
//   /cells                  (c, dimension + 1)   vertices by their numbers within the part
//   /cell_regions           (c)              index into region_names
//   /cell_ids               (c)              numbers of the cells in the whole mesh
//   /splits                 (s, 3)           plus, minus, by their numbers within the part, and 1
//                                            for a tip, 2 for a joint, otherwise 0
//                                            (SplitVertex)
//   /boundaries/<name>/facets      (f, dimension)   vertices by their numbers within the part
//   /boundaries/<name>/facet_ids   (f)       numbers of the facets in the whole mesh's boundary
//
// where n, c, s and f differ from part to part. An array is a group of three datasets:
//
//   <array>/values          (rows of all parts) or (rows of all parts, columns)
//   <array>/offsets         (num_parts + 1)  first row of each part, and the number of all rows
//   <array>/checksums       (num_parts)      of the part's rows (detail::partChecksum)
//
// HDF5's own structures have checksums as well (its format of version 1.8), and strings, which have
// none, fixed lengths.
namespace asperity::mesh
{
struct PartitionSummary
{
  int dimension = 0;
  int num_parts = 0;
  int num_vertices = 0; // of the whole mesh, as are the cells
  int num_cells = 0;
  std::vector<double> period; // (dimension), m
  std::string fingerprint;
  PartitionOptions options;
  std::vector<std::string> region_names;
  std::vector<std::string> boundary_names; // sorted
  std::vector<std::string> faults;         // those inside the body, sorted
};

// Divides the mesh by `owners`, the result of partitionVertices with these options, and writes all
// parts. If the mesh has faults, it is split along them already. The file is complete if it exists.
// Throws InputError if it cannot be written.
template <int Dim>
void writeParts(GlobalMesh<Dim> const& mesh, std::vector<int> const& owners, int num_parts,
                PartitionOptions const& options, std::string const& file_name);

// The part of this rank, equal to localPart of the whole mesh. All ranks read their own rows in
// parallel, and none has the whole mesh at any time. Every rank throws the same InputError if the
// file is missing, malformed, truncated, damaged, of another dimension, or made for another number
// of ranks; in the last case the message contains the command that partitions it again. Collective.
template <int Dim>
Mesh<Dim> readPart(std::string const& file_name, RCP<const Communicator> const& communicator);

// The whole mesh, put together from all parts and checked, on one process. Throws as readPart does.
template <int Dim>
GlobalMesh<Dim> readParts(std::string const& file_name);

// What the file says of its mesh and its parts, without the mesh itself. Throws InputError if it is
// not a partitioned mesh.
PartitionSummary partitionSummary(std::string const& file_name);

// True for a partitioned mesh, false for one of MeshFile.hpp. InputError for anything else. With a
// communicator rank 0 reads, every rank has the same result, and the call is collective.
bool isPartitioned(std::string const& file_name);
bool isPartitioned(std::string const& file_name, Communicator const& communicator);

// The dimension, 2 or 3, of a file of either kind; errors as isPartitioned. Collective.
int fileDimension(std::string const& file_name, Communicator const& communicator);
} // namespace asperity::mesh
