#pragma once

#include "mesh/Mesh.hpp"

#include <string>

namespace asperity::mesh::detail
{
// Throws an InputError that starts with `where` unless numbers are in range, arrays of the same
// vertices or cells have the same length, global ids ascend within the owned vertices and within
// the ghosts, coordinates are finite, cells are positively oriented, both vertices of a pair at a
// fault are at one place and owned or ghosts alike, facets of faults consist of the plus vertices
// of pairs, and no vertex hangs inside an edge or a face (mesh/detail/Conformity.hpp).
template <int Dim>
void checkPart(Mesh<Dim> const& part, std::string const& where);
} // namespace asperity::mesh::detail
