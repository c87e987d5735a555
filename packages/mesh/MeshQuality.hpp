#pragma once

#include "mesh/GlobalMesh.hpp"

// Sizes and boundaries. AnyMesh is GlobalMesh, a whole mesh, or Mesh, a rank's part of one.
namespace asperity::mesh
{
// Diameters (longest edges) of the cells, (num_cells) in m.
template <template <int> class AnyMesh, int Dim>
std::vector<double> cellDiameters(AnyMesh<Dim> const& mesh);

template <int Dim>
struct CellSizes
{
  double smallest_diameter = 0.0;       // m
  double largest_diameter = 0.0;        // m
  double smallest_angle = 0.0;          // rad; between edges in 2D, between faces in 3D
  Point<Dim> place_of_smallest_angle{}; // m, the centroid of the first cell that has it
  double shortest_edge = 0.0;           // m
  Point<Dim> place_of_shortest_edge{};  // m, the middle of the first edge that has it
  double measure = 0.0;                 // m^2 or m^3, all cells together
};
template <int Dim>
CellSizes<Dim> cellSizes(GlobalMesh<Dim> const& mesh);

// The names of the boundaries, sorted.
template <class AnyMesh>
std::vector<std::string> boundaryNames(AnyMesh const& mesh)
{
  std::vector<std::string> names;
  for (auto const& boundary : mesh.boundaries) {
    names.push_back(boundary.first);
  }
  return names;
}

// The facets of a boundary. Throws an InputError with similar or valid names if none has this name.
template <template <int> class AnyMesh, int Dim>
std::vector<typename Mesh<Dim>::Facet> const& boundaryFacets(AnyMesh<Dim> const& mesh,
                                                             std::string const& name);

// Vertices of the facets of a boundary, ascending, each once. In a rank's part these are all owned
// vertices of the boundary, and the ghosts that share a facet with them.
template <template <int> class AnyMesh, int Dim>
std::vector<int> boundaryVertices(AnyMesh<Dim> const& mesh, std::string const& name);

// Shortest edge of the facets of a boundary, in m; infinite if it has no facets.
template <int Dim>
double shortestEdge(GlobalMesh<Dim> const& mesh, std::string const& boundary);
} // namespace asperity::mesh
