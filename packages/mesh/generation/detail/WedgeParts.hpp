#pragma once

#include "mesh/generation/WedgeMesh.hpp"

// Shared by wedges in two and in three dimensions.
namespace asperity::mesh::detail
{
// Throws InputError if the shape is not valid.
void checkWedge(WedgeShape const& shape);

// The whole wedge as one cell, of region `upper`.
GlobalMesh<2> wedgeTriangle(WedgeShape const& shape);

// Regions `upper` and, if the viscous thickness is not zero, `lower` by the vertical depth of the
// cells' centroids below the surface.
template <int Dim>
void assignWedgeRegions(WedgeShape const& shape, GlobalMesh<Dim>& mesh);
} // namespace asperity::mesh::detail
