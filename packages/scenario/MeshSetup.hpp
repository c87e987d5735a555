#pragma once

#include "base/Parameters.hpp"
#include "mesh/Mesh.hpp"

namespace asperity::scenario
{
// The deck's list `Mesh`.
RCP<const ParameterList> meshParameters();

// Makes or reads the mesh and gives every rank its part. Collective.
Mesh<2> makeMesh(ParameterList const& list, RCP<const Communicator> const& communicator);
} // namespace asperity::scenario
