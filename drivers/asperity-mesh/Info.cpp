#include "Arguments.hpp"
#include "Commands.hpp"

#include "base/Text.hpp"
#include "mesh/MeshFile.hpp"
#include "mesh/MeshQuality.hpp"

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
void printMesh(std::string const& file_name)
{
  const auto mesh = asperity::mesh::readMesh<Dim>(file_name);
  const auto sizes = asperity::mesh::cellSizes(mesh);
  const double degree = std::acos(-1.0) / 180.0;
  std::cout << "dimension        " << Dim << '\n'
            << "vertices         " << mesh.vertices.size() << '\n'
            << "cells            " << mesh.cells.size() << '\n'
            << "bounding box     " << boundingBox(mesh) << " m\n"
            << (Dim == 2 ? "area             " : "volume           ") << formatShort(sizes.measure)
            << (Dim == 2 ? " m^2\n" : " m^3\n") << "cell diameters   "
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
    std::cout << "boundary         " << name << ": " << facets.size() << " facets, "
              << asperity::mesh::boundaryVertices(mesh, name).size() << " vertices, shortest edge "
              << formatShort(asperity::mesh::shortestEdge(mesh, name)) << " m\n";
  }
}
} // namespace

void printInfo(std::vector<std::string> const& words)
{
  const auto arguments = parseArguments(words, {{"FILE.h5"}, {}, {}});
  const std::string file_name = arguments.files[0];
  if (asperity::mesh::meshDimension(file_name) == 2) {
    printMesh<2>(file_name);
  } else {
    printMesh<3>(file_name);
  }
}
