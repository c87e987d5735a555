#pragma once

#include "fem/dofs/DofMap.hpp"
#include "mesh/Mesh.hpp"

#include <string>
#include <vector>

namespace asperity::fem
{
// A node's share of a boundary.
template <int Dim>
struct NodalMeasure
{
  int node = 0;        // local vertex number
  double weight = 0;   // integral of the nodal basis function over the boundary [m^(Dim-1)]
  Point<Dim> normal{}; // unit, outward, averaged over the facets by their size
};

// The measures of a rank's owned nodes on a named boundary, ascending. InputError if the mesh has
// no such boundary, or none of its facets on any rank. Collective.
template <int Dim>
std::vector<NodalMeasure<Dim>> boundaryMeasure(Mesh<Dim> const& mesh, std::string const& boundary,
                                               Communicator const& communicator);
// The integral of the outward normal over boundaries, and their measure [m^(Dim-1)]. A plane has
// as long a normal as its measure, a closed surface has none.
struct NormalIntegral
{
  std::array<double, 3> normal{};
  double measure = 0;
};

// The integral over boundaries that the mesh has. Collective.
template <int Dim>
NormalIntegral integrateNormal(Mesh<Dim> const& mesh, std::vector<std::string> const& boundaries,
                               Communicator const& communicator);
} // namespace asperity::fem
