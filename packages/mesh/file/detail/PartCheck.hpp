#pragma once

#include "mesh/Mesh.hpp"

#include <string>

namespace asperity::mesh::detail
{
// Throws an InputError that starts with `where` unless numbers are in range, datasets of the same
// things are equally long, global ids ascend within the owned vertices and within the ghosts,
// coordinates are finite, and cells are positively oriented.
template <int Dim>
void checkPart(Mesh<Dim> const& part, std::string const& where);
} // namespace asperity::mesh::detail
