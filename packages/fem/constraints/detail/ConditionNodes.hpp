#pragma once

#include "mesh/Mesh.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::fem::detail
{
// The inward normals of the owned nodes on some boundaries: sums over the facets of each node,
// whose normals are weighted by their size [m^(Dim - 1)]. They have as many components as a
// displacement.
template <int Dim>
std::map<int, std::vector<double>> inwardNormals(Mesh<Dim> const& mesh, int components,
                                                 std::vector<std::string> const& boundaries);

// Directions at nodes, by their local numbers.
using NodalVectors = std::map<int, std::vector<std::vector<double>>>;

// Projects normals onto the planes of the walls that they nearly lie in (`walls` has the unit
// normals of the walls at each node). Where a boundary ends at a wall, this is the normal of its
// facets and of their mirror images beyond the wall. On a bent boundary the normal of its own
// facets alone misses the plane of the wall by an angle of the order of their size.
void turnIntoWalls(NodalVectors const& walls, std::map<int, std::vector<double>>& normals);

// The owned nodes on a boundary, ascending, each once.
template <int Dim>
std::vector<int> ownedNodes(Mesh<Dim> const& mesh, std::string const& boundary);
} // namespace asperity::fem::detail
