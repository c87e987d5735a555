#pragma once

#include "mesh/generation/Bisection.hpp"

namespace asperity::mesh::detail
{
// A rough lower estimate of the number of vertices of a mesh in which no cell exceeds its allowed
// diameter. It does not refine the mesh, and evaluates the function only a few times.
template <int Dim>
double fewestVertices(GlobalMesh<Dim> const& mesh, SizeFunction<Dim> const& largest_diameter);
} // namespace asperity::mesh::detail
