#pragma once

#include "base/Types.hpp"
#include "mesh/Mesh.hpp"

#include <string>
#include <vector>

namespace asperity::fem
{
// The rigid motions of a body that nothing resists, in words that follow "when it moves": "along
// y", "by turning about an axis along z". Without inertia the equations of such a body have no
// unique solution.
//
// motions: the columns of rigidBodyMotions. resisting(num owned dofs): 1 where a dof is held, or
// where friction or dampers act on its velocity. A combination c of the motions r_i is free if it
// vanishes at all these dofs, that is, if G c = 0 with
//   G_ij = sum over resisting dofs of r_i r_j.
// Every piece of the body is tested separately (BodyPieces); the whole body is tested at once if it
// has pinched vertices. The result does not depend on the number of ranks. Collective.
template <int Dim>
std::vector<std::string> freeMotions(Mesh<Dim> const& mesh, int components,
                                     MultiVector const& motions, std::vector<int> const& resisting,
                                     RCP<const Communicator> const& communicator);
} // namespace asperity::fem
