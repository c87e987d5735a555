#pragma once

#include "mesh/GlobalMesh.hpp"

// Sizes and boundaries, of a whole mesh or of a rank's part of one.
namespace asperity::mesh
{
// Diameters (longest edges) of the cells, (num_cells) in m.
template <int Dim>
std::vector<double> cellDiameters(GlobalMesh<Dim> const& mesh);
template <int Dim>
std::vector<double> cellDiameters(Mesh<Dim> const& mesh);

struct CellSizes
{
  double smallest_diameter = 0.0; // m
  double largest_diameter = 0.0;  // m
  double smallest_angle = 0.0;    // rad; between edges in 2D, between faces in 3D
  double measure = 0.0;           // m^2 or m^3, all cells together
};
template <int Dim>
CellSizes cellSizes(GlobalMesh<Dim> const& mesh);

// The facets of a boundary. Throws an InputError with similar or valid names if none has this name.
template <int Dim>
std::vector<typename Mesh<Dim>::Facet> const& boundaryFacets(GlobalMesh<Dim> const& mesh,
                                                             std::string const& name);
template <int Dim>
std::vector<typename Mesh<Dim>::Facet> const& boundaryFacets(Mesh<Dim> const& mesh,
                                                             std::string const& name);

// Vertices of the facets of a boundary, ascending, each once. In a rank's part these are all owned
// vertices of the boundary, and the ghosts that share a facet with them.
template <int Dim>
std::vector<int> boundaryVertices(GlobalMesh<Dim> const& mesh, std::string const& name);
template <int Dim>
std::vector<int> boundaryVertices(Mesh<Dim> const& mesh, std::string const& name);

// Shortest edge of the facets of a boundary, in m; infinite if it has no facets.
template <int Dim>
double shortestEdge(GlobalMesh<Dim> const& mesh, std::string const& boundary);
} // namespace asperity::mesh
