#pragma once

#include "base/Hashes.hpp"
#include "mesh/file/PartitionedFile.hpp"
#include "mesh/file/detail/MeshFileReader.hpp"

// Shared by the writer and the readers of partitioned files (PartitionedFile.hpp).
namespace asperity::mesh::detail
{
constexpr char partition_format[] = "asperity-partition";
constexpr int partition_version = 2;

// Throws InputError unless the file is a partitioned mesh.
PartitionSummary readSummary(MeshFileReader const& file);

// A number that depends on everything that the parts must agree on. The checksums of all rows start
// from it, so that rows of another mesh, or for another number of parts, are detected.
std::uint64_t seedOf(PartitionSummary const& summary);

// The checksum of the rows of an array that belong to a part.
template <class Row>
std::uint64_t partChecksum(std::uint64_t seed, std::string const& array, int part,
                           std::vector<Row> const& rows)
{
  return Checksum(seed).add(array).add(part).add(rows).value();
}

template <int Dim>
std::string fingerprint(GlobalMesh<Dim> const& mesh);

inline std::string boundaryArray(std::string const& boundary, std::string const& what)
{
  return "/boundaries/" + boundary + "/" + what;
}

// The command that makes a file of wanted_parts parts from this file, which has num_parts.
std::string partitionCommand(std::string const& file_name, int num_parts, int wanted_parts);
} // namespace asperity::mesh::detail
