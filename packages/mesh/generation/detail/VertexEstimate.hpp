#pragma once

#include "mesh/generation/Bisection.hpp"

namespace asperity::mesh::detail
{
// Roughly as many vertices as a mesh has at least when no cell exceeds its allowed diameter, found
// without refining it: few calls of the function, whatever the answer.
template <int Dim>
double fewestVertices(GlobalMesh<Dim> const& mesh, SizeFunction<Dim> const& largest_diameter);
} // namespace asperity::mesh::detail
