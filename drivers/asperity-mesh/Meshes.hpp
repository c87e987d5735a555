#pragma once

#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/file/PartitionedFile.hpp"

#include <iostream>
#include <optional>

// Writes the file and prints how large the mesh is, and `more`.
template <int Dim>
void writeAndReport(asperity::GlobalMesh<Dim> const& mesh, std::string const& file_name,
                    std::string const& more = "")
{
  asperity::mesh::writeMesh(mesh, file_name);
  std::cout << file_name << ": " << mesh.vertices.size() << " vertices, " << mesh.cells.size()
            << " cells" << more << '\n';
}

// Reads the mesh of a file, partitioned or not, splits it along its faults unless it is split
// already, and calls work(mesh, summary) with its GlobalMesh of 2 or 3 dimensions and what the file
// says of its parts, if it has any.
template <class Work>
void withMesh(std::string const& file_name, Work const& work)
{
  std::optional<asperity::mesh::PartitionSummary> parts;
  if (asperity::mesh::isPartitioned(file_name)) {
    parts = asperity::mesh::partitionSummary(file_name);
  }
  const auto read = [&](auto dimension) {
    constexpr int Dim = decltype(dimension)::value;
    auto mesh =
      parts ? asperity::mesh::readParts<Dim>(file_name) : asperity::mesh::readMesh<Dim>(file_name);
    asperity::mesh::splitFaults(mesh, "Mesh file '" + file_name + "'");
    work(mesh, parts);
  };
  if ((parts ? parts->dimension : asperity::mesh::meshDimension(file_name)) == 2) {
    read(std::integral_constant<int, 2>());
  } else {
    read(std::integral_constant<int, 3>());
  }
}
