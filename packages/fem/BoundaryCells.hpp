#pragma once

#include "fem/FaultSurface.hpp"
#include "fem/Material.hpp"

namespace asperity::fem
{
// The cell beside each facet of a boundary, in the order of mesh.boundaries.
template <int Dim>
std::vector<int> cellsBeside(Mesh<Dim> const& mesh, std::string const& boundary);

// The material at each node of the fault: that of the cells beside its facets there, averaged by
// the size of the facets. materials(num_cells).
template <int Dim>
std::vector<Material> materialsAtNodes(Mesh<Dim> const& mesh, FaultSurface const& fault,
                                       std::vector<Material> const& materials);
} // namespace asperity::fem
