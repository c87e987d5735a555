#pragma once

#include "mesh/faults/detail/FaultFacets.hpp"
#include "mesh/faults/detail/Star.hpp"

namespace asperity::mesh::detail
{
// How one vertex of a fault is split.
struct VertexSplit
{
  bool is_cut = false;         // false: the vertex is a tip of all faults there
  std::vector<int> plus_cells; // of the cut
  struct Branch
  {
    int fault;
    bool is_on_plus_side; // of the cut
  };
  std::vector<Branch> branches; // faults with a tip at the cut, ascending
};

// A vertex of a fault and its surroundings.
template <int Dim>
struct FaultVertex
{
  Point<Dim> place;
  std::vector<int> facets; // of faults, at the vertex
  bool is_on_surface;      // of the body
  bool is_on_trace;        // an edge of these facets through the vertex lies in the surface
};

// InputError, which starts with `where`, if the vertex cannot be split. `facets` are the facets of
// all faults, `names` the names of the faults.
template <int Dim>
VertexSplit splitVertex(Star<Dim> const& star, FaultVertex<Dim> const& vertex,
                        std::vector<FaultFacet<Dim>> const& facets,
                        std::vector<std::string> const& names, std::string const& where);
} // namespace asperity::mesh::detail
