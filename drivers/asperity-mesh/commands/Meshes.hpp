#pragma once

#include "mesh/GlobalMesh.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/file/PartitionedFile.hpp"

#include <iostream>
#include <optional>
#include <string>
#include <type_traits>

namespace asperity::geometry
{
// Writes the file and prints how large the mesh is, and `more`.
template <int Dim>
void writeAndReport(GlobalMesh<Dim> const& mesh, std::string const& file_name,
                    std::string const& more = "")
{
  mesh::writeMesh(mesh, file_name);
  std::cout << file_name << ": " << mesh.vertices.size() << " vertices, " << mesh.cells.size()
            << " cells" << more << '\n';
}

// Reads the mesh of a file, partitioned or not, splits it along its faults unless it is split
// already, and calls work(mesh, summary) with its GlobalMesh of 2 or 3 dimensions and what the file
// says of its parts, if it has any. in_the_plane: how branches end in two dimensions.
template <class Work>
void withMesh(std::string const& file_name, Work const& work,
              mesh::BranchEnd in_the_plane = mesh::BranchEnd::tip)
{
  std::optional<mesh::PartitionSummary> parts;
  if (mesh::isPartitioned(file_name)) {
    parts = mesh::partitionSummary(file_name);
  }
  const auto read = [&](auto dimension) {
    constexpr int Dim = decltype(dimension)::value;
    auto mesh = parts ? mesh::readParts<Dim>(file_name) : mesh::readMesh<Dim>(file_name);
    mesh::splitFaults(mesh, "Mesh file '" + file_name + "'",
                      Dim == 2 ? in_the_plane : mesh::BranchEnd::joint);
    work(mesh, parts);
  };
  if ((parts ? parts->dimension : mesh::meshDimension(file_name)) == 2) {
    read(std::integral_constant<int, 2>());
  } else {
    read(std::integral_constant<int, 3>());
  }
}
} // namespace asperity::geometry
