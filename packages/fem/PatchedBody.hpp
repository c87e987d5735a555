#pragma once

#include "fem/BodyMatrices.hpp"
#include "fem/VolumetricPatches.hpp"

namespace asperity::fem
{
// Like assembleBody, for a body whose cells share volumetric strains in patches. The graph couples
// the vertices of a patch; mass, viscosity and branches are those of single cells. The stiffness of
// the patches never relaxes. A rank needs all cells of its patches.
template <int Dim>
BodyMatrices assemblePatchedBody(Mesh<Dim> const& mesh, DofMap const& dofs,
                                 NodalFrames const& frames, std::vector<Material> const& materials,
                                 std::vector<MaxwellBranch> const& branches,
                                 VolumetricPatches const& patches);
} // namespace asperity::fem
