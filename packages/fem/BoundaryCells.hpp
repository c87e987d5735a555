#pragma once

#include "fem/FaultSurface.hpp"
#include "fem/Material.hpp"

namespace asperity::fem
{
// Of a fault inside the body; a boundary has the plus side alone.
enum class Side
{
  plus,
  minus
};

// The cell beside each facet of a boundary, in the order of mesh.boundaries.
template <int Dim>
std::vector<int> cellsBeside(Mesh<Dim> const& mesh, std::string const& boundary,
                             Side side = Side::plus);

// The material at each node of the fault: that of the cells beside its facets there, averaged by
// the size of the facets. Between two bodies it is that of two equal ones that together resist slip
// and radiate as these do: shear and bulk modulus and shear impedance are the harmonic means, the
// viscosities the means of the two sides. materials(num_cells).
template <int Dim>
std::vector<Material> materialsAtNodes(Mesh<Dim> const& mesh, FaultSurface const& fault,
                                       std::vector<Material> const& materials);
} // namespace asperity::fem
