#pragma once

#include "base/parameters/Parameters.hpp"
#include "mesh/Mesh.hpp"

namespace asperity::scenario
{
// The deck's list `Mesh`.
RCP<const ParameterList> meshParameters();

// Of the mesh that the list describes: 2 or 3. Reads the header of a file. Collective.
int meshDimension(ParameterList const& list, Communicator const& communicator);

// Makes or reads the mesh and gives every rank its part, with as many vertices of the boundary
// `fault` as the others have, unless a file has chosen the parts. The mesh is split along the
// faults inside the body. Dim is meshDimension. Collective.
template <int Dim>
Mesh<Dim> makeMesh(ParameterList const& list, std::string const& fault,
                   RCP<const Communicator> const& communicator);
} // namespace asperity::scenario
