#pragma once

#include "fem/DofMap.hpp"
#include "mesh/Mesh.hpp"

#include <string>
#include <vector>

namespace asperity::fem
{
// The owned nodes of a rank on a named boundary, in the order of the rank's vertices.
template <int Dim>
struct BoundaryNodes
{
  std::vector<int> nodes;          // (num_nodes) local vertex numbers, ascending
  std::vector<double> weights;     // (num_nodes) integral of the nodal basis function [m^(Dim-1)]
  std::vector<Point<Dim>> normals; // (num_nodes) unit outward normals, averaged over the facets
};

// InputError if the mesh has no such boundary, or none of its facets on any rank.
template <int Dim>
BoundaryNodes<Dim> boundaryNodes(Mesh<Dim> const& mesh, std::string const& boundary,
                                 Communicator const& communicator);
} // namespace asperity::fem
