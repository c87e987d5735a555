#pragma once

#include "mesh/Mesh.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::fem::detail
{
// Inward normals of the owned nodes on some boundaries, as long as their facets are large
// [m^(Dim - 1)]; as many components as a displacement has.
template <int Dim>
std::map<int, std::vector<double>> inwardNormals(Mesh<Dim> const& mesh, int components,
                                                 std::vector<std::string> const& boundaries);

// Directions at nodes, by their local numbers.
using NodalVectors = std::map<int, std::vector<std::vector<double>>>;

// Turns normals into the planes of walls (unit normals at each node) that they nearly lie in: what
// a boundary's facets and their mirror images beyond a wall add up to where it ends there. Across
// an edge of triangles on a bent boundary its own facets alone miss that plane by their size.
void turnIntoWalls(NodalVectors const& walls, std::map<int, std::vector<double>>& normals);

// The owned nodes on a boundary, ascending, each once.
template <int Dim>
std::vector<int> ownedNodes(Mesh<Dim> const& mesh, std::string const& boundary);
} // namespace asperity::fem::detail
