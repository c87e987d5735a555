#pragma once

#include "mesh/GlobalMesh.hpp"
#include "parameters/Parameters.hpp"

#include <string>
#include <vector>

namespace asperity::scenario
{
// The lists of `Mesh` for the bodies that are meshed here, by the words of `Type`.
std::vector<Declare::NamedList> generatedMeshParameters();

// The whole mesh of the type that its list describes. Throws InputError if it would have more than
// most_vertices, or if the numbers of the list make no mesh.
template <int Dim>
GlobalMesh<Dim> generateMesh(ParameterList const& list, std::string const& type, int most_vertices);
} // namespace asperity::scenario
