#pragma once

#include "mesh/GlobalMesh.hpp"
#include "parameters/Parameters.hpp"

#include <vector>

namespace asperity::scenario
{
// The lists of `Mesh` for the bodies that are meshed here, by the words of `Type`.
std::vector<Declare::NamedList> generatedMeshParameters();

// The whole mesh that the deck's list `Mesh` describes. Throws InputError if it would have more
// vertices than `Most Vertices` allows, or if the numbers of its list make no mesh.
template <int Dim>
GlobalMesh<Dim> generateMesh(ParameterList const& mesh);
} // namespace asperity::scenario
