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

// The owned nodes on a boundary, ascending, each once.
template <int Dim>
std::vector<int> ownedNodes(Mesh<Dim> const& mesh, std::string const& boundary);
} // namespace asperity::fem::detail
