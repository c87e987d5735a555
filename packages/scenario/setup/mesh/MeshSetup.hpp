#pragma once

#include "mesh/Mesh.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "scenario/setup/mesh/MeshSettings.hpp"

#include <string>

namespace asperity::scenario
{
// The dimension of the mesh that the deck's list `Mesh` describes, 2 or 3. If the mesh is in a
// file, its header is read. Collective.
int meshDimension(ParameterList const& list, Communicator const& communicator);

// Makes or reads the mesh and gives every rank its part, with as many vertices of the boundary
// `fault` as any other rank has, unless the mesh file defines the parts. The mesh is split along
// the faults inside the body; branches end as branch_end says, unless the file has them split. Dim
// must be meshDimension. Collective.
template <int Dim>
Mesh<Dim> makeMesh(MeshSettings const& settings, std::string const& fault,
                   mesh::BranchEnd branch_end, RCP<const Communicator> const& communicator);
} // namespace asperity::scenario
