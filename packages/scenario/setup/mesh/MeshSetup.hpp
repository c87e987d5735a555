#pragma once

#include "mesh/Mesh.hpp"
#include "mesh/faults/SplitFaults.hpp"
#include "parameters/Parameters.hpp"

namespace asperity::scenario
{
// The entry of the list `Mesh` that names boundaries and faults beside which cells become flat.
inline constexpr char const* flat_cells_beside = "Flat Cells Beside";

// The deck's list `Mesh`.
RCP<const ParameterList> meshParameters();

// The dimension of the mesh that the list describes, 2 or 3. If the mesh is in a file, its header
// is read. Collective.
int meshDimension(ParameterList const& list, Communicator const& communicator);

// Makes or reads the mesh and gives every rank its part, with as many vertices of the boundary
// `fault` as any other rank has, unless the mesh file defines the parts. The mesh is split along
// the faults inside the body; branches end as branch_end says, unless the file has them split. Dim
// must be meshDimension. Collective.
template <int Dim>
Mesh<Dim> makeMesh(ParameterList const& list, std::string const& fault, mesh::BranchEnd branch_end,
                   RCP<const Communicator> const& communicator);
} // namespace asperity::scenario
