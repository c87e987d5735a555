#include "Arguments.hpp"
#include "Commands.hpp"

#include "base/Text.hpp"
#include "mesh/MeshQuality.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "mesh/file/MeshFile.hpp"
#include "mesh/file/PartitionedFile.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
using asperity::formatShort;

template <int Dim>
std::string boundingBox(asperity::GlobalMesh<Dim> const& mesh)
{
  std::string box;
  for (int d = 0; d < Dim; ++d) {
    double low = mesh.vertices.front()[d], high = low;
    for (auto const& vertex : mesh.vertices) {
      low = std::min(low, vertex[d]);
      high = std::max(high, vertex[d]);
    }
    box += (d == 0 ? "[" : " x [") + formatShort(low) + ", " + formatShort(high) + "]";
  }
  return box;
}

template <int Dim>
std::string period(asperity::GlobalMesh<Dim> const& mesh)
{
  std::string lines;
  for (int d = 0; d < Dim; ++d) {
    if (mesh.period[d] > 0.0) {
      lines +=
        std::string("period along ") + "xyz"[d] + "   " + formatShort(mesh.period[d]) + " m\n";
    }
  }
  return lines;
}

void printPartition(asperity::mesh::PartitionSummary const& summary)
{
  std::cout << "parts            " << summary.num_parts;
  if (!summary.options.boundary.empty()) {
    std::cout << ", with boundary " << summary.options.boundary << " balanced";
  }
  std::cout << "\nfingerprint      " << summary.fingerprint << '\n';
}

template <int Dim>
bool isFault(asperity::GlobalMesh<Dim> const& mesh, std::string const& boundary)
{
  return std::binary_search(mesh.faults.begin(), mesh.faults.end(), boundary);
}

// The number of vertices of a fault at which it ends inside the body.
template <int Dim>
int numTips(asperity::GlobalMesh<Dim> const& mesh, std::string const& fault)
{
  const auto vertices = asperity::mesh::boundaryVertices(mesh, fault);
  return static_cast<int>(
    std::count_if(mesh.splits.begin(), mesh.splits.end(), [&](auto const& pair) {
      return pair.is_tip && std::binary_search(vertices.begin(), vertices.end(), pair.plus);
    }));
}

// The copies are made when the mesh is read; the file has them if it is partitioned.
template <int Dim>
std::string copies(asperity::GlobalMesh<Dim> const& mesh)
{
  return mesh.splits.empty()
           ? ""
           : ", " + std::to_string(mesh.splits.size()) + " of them copies at faults";
}

template <int Dim>
void printMesh(std::string const& file_name, bool is_partitioned)
{
  auto mesh = is_partitioned ? asperity::mesh::readParts<Dim>(file_name)
                             : asperity::mesh::readMesh<Dim>(file_name);
  asperity::mesh::splitFaults(mesh, "Mesh file '" + file_name + "'"); // if they are not split yet
  const auto sizes = asperity::mesh::cellSizes(mesh);
  if (is_partitioned) {
    printPartition(asperity::mesh::partitionSummary(file_name));
  }
  const double degree = std::acos(-1.0) / 180.0;
  std::cout << "dimension        " << Dim << '\n'
            << "vertices         " << mesh.vertices.size() << copies(mesh) << '\n'
            << "cells            " << mesh.cells.size() << '\n'
            << "bounding box     " << boundingBox(mesh) << " m\n"
            << period(mesh) << (Dim == 2 ? "area             " : "volume           ")
            << formatShort(sizes.measure) << (Dim == 2 ? " m^2\n" : " m^3\n") << "cell diameters   "
            << formatShort(sizes.smallest_diameter) << " to " << formatShort(sizes.largest_diameter)
            << " m\n"
            << "smallest angle   " << formatShort(sizes.smallest_angle / degree) << " degrees\n";
  std::vector<int> num_cells(mesh.region_names.size(), 0);
  for (int region : mesh.cell_regions) {
    ++num_cells[static_cast<std::size_t>(region)];
  }
  for (std::size_t r = 0; r < num_cells.size(); ++r) {
    std::cout << "region           " << mesh.region_names[r] << ": " << num_cells[r] << " cells\n";
  }
  for (auto const& [name, facets] : mesh.boundaries) {
    const int tips = numTips(mesh, name);
    std::cout << (isFault(mesh, name) ? "fault            " : "boundary         ") << name << ": "
              << facets.size() << " facets, " << asperity::mesh::boundaryVertices(mesh, name).size()
              << " vertices, "
              << (isFault(mesh, name) ? std::to_string(tips) + (tips == 1 ? " tip, " : " tips, ")
                                      : "")
              << "shortest edge " << formatShort(asperity::mesh::shortestEdge(mesh, name))
              << " m\n";
  }
}
} // namespace

void printInfo(std::vector<std::string> const& words)
{
  const auto arguments = parseArguments(words, {{"FILE.h5"}, {}, {}});
  const std::string file_name = arguments.files[0];
  const bool is_partitioned = asperity::mesh::isPartitioned(file_name);
  const int dimension = is_partitioned ? asperity::mesh::partitionSummary(file_name).dimension
                                       : asperity::mesh::meshDimension(file_name);
  if (dimension == 2) {
    printMesh<2>(file_name, is_partitioned);
  } else {
    printMesh<3>(file_name, is_partitioned);
  }
}
