#pragma once

#include "mesh/detail/FacetTable.hpp"

namespace asperity::mesh::detail
{
// A facet of a fault, between two cells.
template <int Dim>
struct FaultFacet
{
  using Facet = typename GlobalMesh<Dim>::Facet;

  Facet key;                // sorted vertices
  int fault = 0;            // number of the fault's name
  std::size_t number = 0;   // in the fault's boundary
  std::array<int, 2> cells; // on the plus side, on the minus side
  Facet outward;            // seen from the cell on the plus side
};

template <int Dim>
struct OrientedFacets
{
  std::vector<FaultFacet<Dim>> facets; // sorted by key
  // Numbers of facets of two faults that are one fault at their common ridge.
  std::vector<std::array<int, 2>> joined;
};

// All facets of the faults `names`, oriented as SplitFaults.hpp says. InputError, which starts with
// `where`, if a facet is in two faults or they cannot be oriented.
template <int Dim>
OrientedFacets<Dim> orientedFaultFacets(GlobalMesh<Dim> const& mesh, FacetTable<Dim> const& table,
                                        std::vector<std::string> const& names,
                                        std::string const& where);
} // namespace asperity::mesh::detail
