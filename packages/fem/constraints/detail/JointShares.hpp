#pragma once

#include "fem/dofs/DofMap.hpp"
#include "mesh/Joints.hpp"

namespace asperity::fem::detail
{
// (num_joints) of each joint of a part, in the order of mesh::jointsOf: the share of the main
// fault's facets at its vertex, by their measure, that lie on the plus side of the branch.
// Collective.
template <int Dim>
std::vector<double> jointShares(Mesh<Dim> const& mesh, DofMap const& dofs);
} // namespace asperity::fem::detail
