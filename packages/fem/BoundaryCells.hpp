#pragma once

#include "fem/FaultSurface.hpp"
#include "fem/bulk/Material.hpp"

namespace asperity::fem
{
// The sides of a fault inside the body. A boundary of the body has only the plus side.
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
// the size of the facets. Between two bodies it is the material of two equal bodies that together
// resist slip and radiate as these two do: shear modulus, bulk modulus and shear impedance are the
// harmonic means of the two sides, the viscosities are the arithmetic means. materials(num_cells).
template <int Dim>
std::vector<Material> materialsAtNodes(Mesh<Dim> const& mesh, FaultSurface const& fault,
                                       std::vector<Material> const& materials);
} // namespace asperity::fem
